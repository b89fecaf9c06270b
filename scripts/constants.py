#!/usr/bin/env python3
"""Lists the named constants of a folder as rows of docs/constants.md: scripts/constants.py FOLDER

What a constant is, is what stands beside it in the code."""
import pathlib
import re
import sys

DECLARED = re.compile(
    r"\s*(?:inline )?constexpr (?:double|int|long|auto|std::array(?:<[^>]*>)?) (k[A-Z]\w*)"
    r"\s*(?:=\s*|\{)(.*)")
COMMENT = re.compile(r"\s*//[/<!]*\s?")


def entry(lines, at):
    """Name, value and comment of the constant declared on a line, or None."""
    found = DECLARED.match(lines[at])
    if not found:
        return None
    name, rest = found.groups()
    while ";" not in rest and at + 1 < len(lines):
        at += 1
        rest += " " + lines[at].strip()
    value, _, words = rest.partition(";")
    words = COMMENT.sub("", words, count=1).strip()
    while words and at + 1 < len(lines) and re.match(r"\s{8,}//", lines[at + 1]):
        at += 1
        words += " " + COMMENT.sub("", lines[at], count=1).strip()
    return name, value.strip().rstrip("}"), words


def main():
    folder = pathlib.Path(__file__).resolve().parent.parent / sys.argv[1]
    print("| constant | value | where | what it is |\n|---|---|---|---|")
    for file in sorted([*folder.glob("*.hpp"), *folder.glob("*.cpp")]):
        lines = file.read_text().splitlines()
        for at, line in enumerate(lines):
            found = entry(lines, at)
            if not found:
                continue
            name, value, words = found
            above = lines[at - 1] if at > 0 else ""
            if not words and COMMENT.match(above):
                words = COMMENT.sub("", above, count=1).strip()
            print(f"| {name} | {value} | {file.name} | {words.replace('|', '&#124;')} |")


if __name__ == "__main__":
    main()
