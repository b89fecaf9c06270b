#!/usr/bin/env python3
"""Re-evaluates the bars of a `shellback honesty --json FILE` run with other constants.

Usage: bars_from_honesty.py FILE. Prints for each variant: share of grid bars that hold the truth
grid and their median length over the error, share that hold the limit of fine grids, share of the
sums of grid and model bars that hold the full physics (docs/constants.md, fidelity)."""
import json, math, sys


def number(x):
    return x if isinstance(x, (int, float)) else math.nan


def onward(m, n, end, p):
    if n >= end or n <= m:
        return 0.0
    error = lambda cells: 0.0 if cells == math.inf else cells ** -p
    return (error(n) - error(end)) / (error(m) - error(n))


def grid_bar(s, least, most, safety, iteration, memory, slow):
    """fidelity/grid_error.hpp (2) to (4)."""
    v = [(h, number(f)) for h, f in zip(s["cell_sizes"], s["levels"]) if math.isfinite(number(f))]
    if len(v) < 2:
        return math.nan
    own = 1.0 / math.sqrt(s["grid"][0] * s["grid"][1])
    (h2, f2), (h1, f1) = v[-2], v[-1]
    d, p, moves_on = abs(f2 - f1), least, False
    if len(v) > 2:
        h3, f3 = v[-3]
        nxt = lambda q: onward(1 / h3, 1 / h2, 1 / h1, q)
        before, last = f2 - f3, f1 - f2
        if memory:
            d = max(d, abs(before) * nxt(most))
        if last == 0.0:
            p = most
        elif before != 0.0 and 0.0 <= last / before <= nxt(0.5):
            low, high = least, most
            for _ in range(40):
                p = 0.5 * (low + high)
                low, high = (p, high) if nxt(p) > last / before else (low, p)
        elif before != 0.0 and last / before > nxt(0.5) and min(h2 / h1, h3 / h2) >= 1.7:
            moves_on = True
    F = safety * math.sqrt(max(1.0, own * math.sqrt(5000.0)))
    rest = lambda q: d * onward(1 / h2, 1 / h1, math.inf, q) * (own / h1) ** q
    bar = max(F * rest(p), safety * rest(slow) if moves_on else 0.0) + iteration * number(s["size"])
    nodes = abs(number(s["node_change"]))
    return bar + (nodes if math.isfinite(nodes) else 0.0)


def judge(samples, label, least=1.0, most=1.75, safety=1.5, iteration=1e-4, memory=True, model=1.75, share=0.2,
          slow=0.5):
    grid, limit, total = [], [], []
    bars, results = [], {}
    for s in samples:
        bar = math.nan if s["given"] else grid_bar(s, least, most, safety, iteration, memory, slow)
        bars.append(bar)
        if math.isfinite(bar) and number(s["size"]) > 0.0:
            results.setdefault((s["case"], s["tier"], tuple(s["grid"])), []).append(bar / s["size"])
    for s, bar in zip(samples, bars):
        if not math.isfinite(bar):
            continue
        relative = sorted(results.get((s["case"], s["tier"], tuple(s["grid"])), [0.0]))
        bar = max(bar, share * relative[len(relative) // 2] * number(s["size"]))
        def add(to, truth, length):
            error = abs(s["value"] - number(truth))
            if max(error, length) > 1e-9 * number(s["size"]):
                to.append(length / error if error > 0.0 else math.inf)
        add(grid, s["truth_tier"], bar)
        add(limit, s["truth_limit"], bar)
        # the run's own model bar is 1.75 times the change
        left_out = model / 1.75 * number(s["error_model"])
        if math.isfinite(left_out) or s["richest"]:
            add(total, s["truth_full"], bar + (left_out if math.isfinite(left_out) else 0.0))
    share = lambda r: 100.0 * sum(x >= 1.0 for x in r) / len(r)
    median = lambda r: sorted(r)[len(r) // 2]
    print(f"{label:22} grid {share(grid):.1f} % median {median(grid):.2f}, limit {share(limit):.1f} %, "
          f"sums {share(total):.1f} % median {median(total):.2f}")


samples = json.load(open(sys.argv[1]))["samples"]
judge(samples, "as it is")
for x in (0.0, 0.1, 0.4):
    judge(samples, f"share {x}", share=x)
for x in (1.25, 1.75, 2.0):
    judge(samples, f"safety of grids {x}", safety=x)
for x in (1.0, 1.5, 2.5):
    judge(samples, f"safety of physics {x}", model=x)
for x in (0.75, 1.25):
    judge(samples, f"least order {x}", least=x)
for x in (1.5, 2.0):
    judge(samples, f"most order {x}", most=x)
for x in (0.0, 1e-3):
    judge(samples, f"iteration {x}", iteration=x)
for x in (0.25, 0.35, 1.0):
    judge(samples, f"slow order {x}", slow=x)
judge(samples, "without (3)", memory=False)
