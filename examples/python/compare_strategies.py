"""Times and lengths of every strategy on one part, as a picture: compare_strategies.py [PART]."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import clearcut

BRACKET = Path(__file__).resolve().parents[1] / "bracket.json"

part = clearcut.read_part(sys.argv[1] if len(sys.argv) > 1 else BRACKET)
plans = {}
for strategy in ("zigzag", "spiral", "contour", "adaptive"):
    try:
        plans[strategy] = clearcut.plan(part, tools="endmill:6", strategy=strategy, stepdown=2)
    except clearcut.InputError as error:
        print(f"{strategy}: {error}")

figure, axes = plt.subplots(1, len(plans), figsize=(4 * len(plans), 4), sharex=True, sharey=True)
for axis, (strategy, plan) in zip(axes, plans.items()):
    moves = plan.moves
    cuts = moves.kind != clearcut.Moves.kinds.index("rapid")
    deepest = cuts & (moves.z == moves.z.min())
    segments = [[(x0, y0), (x1, y1)] for x0, y0, x1, y1 in
                zip(moves.from_x[deepest], moves.from_y[deepest], moves.x[deepest], moves.y[deepest])]
    axis.add_collection(matplotlib.collections.LineCollection(segments, linewidths=0.6))
    axis.set_title(f"{strategy}\n{plan.findings.all.time_s:.0f} s, {plan.verdict}")
    axis.autoscale()
    axis.set_aspect("equal")
figure.savefig("strategies.png", dpi=120, bbox_inches="tight")
for strategy, plan in plans.items():
    print(f"{strategy:9} {plan.verdict:6} {plan.findings.all.feed_mm:7.0f} mm {plan.findings.all.time_s:6.1f} s")
