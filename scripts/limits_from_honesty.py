#!/usr/bin/env python3
"""What values led on from nested grids are worth: `shellback honesty --json FILE`, judged anew.

Usage: limits_from_honesty.py FILE [CELLS]. The two finest grids of each bar lead on to the truth's
grid (CELLS of it, 20000 of 400 x 50; fidelity/grid_error.hpp (5) to there instead of to the limit),
whose values were solved for. Prints per grid and quantity the number of values, and for the value
as it is, for orders 1 to 2 and for the observed one: median and ninth tenth of the error over the
natural size, and the part that is nearer to the truth than the value as it is."""
import json, math, sys

QUANTITIES = ["friction_torque", "friction_torque_asperity", "h_min", "p_max", "p_asperity_max",
              "eccentricity_ratio", "side_flow", "T_film_max"]
ORDERS = [None, 1.0, 1.25, 1.5, 1.75, 2.0, "observed"]


def onward(m, n, end, p):
    error = lambda cells: cells ** -p
    return (error(n) - error(end)) / (error(m) - error(n))


def observed(v):
    """Order in [1, 1.75] of three values, 1.75 where they show none."""
    if len(v) < 3:
        return 1.75
    (h3, f3), (h2, f2), (h1, f1) = v[-3:]
    if f2 == f3 or not 0.0 <= (f1 - f2) / (f2 - f3):
        return 1.75
    low, high = 1.0, 1.75
    for _ in range(40):
        p = 0.5 * (low + high)
        above = onward(1 / h3, 1 / h2, 1 / h1, p) > (f1 - f2) / (f2 - f3)
        low, high = (p, high) if above else (low, p)
    return 0.5 * (low + high)


def errors(s, cells):
    """Errors over the natural size, one for each of ORDERS; none: nothing to lead on."""
    known = lambda x: isinstance(x, (int, float)) and math.isfinite(x)
    v = [(h, f) for h, f in zip(s["cell_sizes"], s["levels"]) if known(f)]
    if s["given"] or len(v) < 2 or not known(s["truth_tier"]) or not s["size"]:
        return None
    (h2, f2), (h1, f1) = v[-2:]
    if f1 != s["value"] or h1 <= cells ** -0.5:  # the finest is not the result's own grid
        return None
    found = []
    for order in ORDERS:
        p = observed(v) if order == "observed" else order
        led = 0.0 if p is None else (f1 - f2) * onward(1 / h2, 1 / h1, cells ** 0.5, p)
        found.append(abs(f1 + led - s["truth_tier"]) / s["size"])
    return found


def main():
    cells = float(sys.argv[2]) if len(sys.argv) > 2 else 400.0 * 50.0
    judged = {}
    for s in json.load(open(sys.argv[1]))["samples"]:
        found = errors(s, cells)
        if found:
            judged.setdefault((tuple(s["grid"]), s["quantity"]), []).append(found)
    head = "".join(f"{'as it is' if o is None else o:>24}" for o in ORDERS)
    print(f"{'grid, quantity':38}{'n':>5}{head}")
    for grid in sorted({g for g, _ in judged}, reverse=True):
        for name in QUANTITIES:
            all_of = judged.get((grid, name))
            if not all_of:
                continue
            n, line = len(all_of), ""
            for k in range(len(ORDERS)):
                e = sorted(f[k] for f in all_of)
                nearer = sum(f[k] < f[0] for f in all_of) / n
                tail = "     " if k == 0 else f" {100 * nearer:3.0f}%"
                line += f"  {100 * e[n // 2]:7.3f} {100 * e[int(0.9 * n)]:7.2f}{tail} "
            print(f"{grid[0]} x {grid[1]:<4} {name:27}{n:>5}{line}")


main()
