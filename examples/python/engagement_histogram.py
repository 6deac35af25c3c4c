"""How much of the cutter is in material, along two plans of one pocket."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import clearcut

part = clearcut.part([[0, 0], [80, 0], [80, 50], [0, 50]], depth=5, name="plain")
figure, axis = plt.subplots(figsize=(7, 4))
for strategy, most in (("contour", None), ("adaptive", 70)):
    plan = clearcut.plan(part, tools="endmill:8", strategy=strategy, stepdown=5, engagement=most)
    moves = plan.moves
    axis.hist(moves.mean_engagement, bins=range(0, 190, 10), weights=moves.cutting_mm, alpha=0.6,
              label=f"{strategy}: at most {moves.engagement.max():.0f} degrees, {moves.time.sum():.0f} s")
axis.set_xlabel("mean engagement of a move, degrees")
axis.set_ylabel("length in material, mm")
axis.legend()
figure.savefig("engagement.png", dpi=120, bbox_inches="tight")
