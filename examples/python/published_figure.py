"""The study behind a published figure, repeated: which crossover serves the genetic algorithm best on a lattice."""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

import clearcut

runs, generations = (int(word) for word in sys.argv[1:3]) if len(sys.argv) > 2 else (20, 2000)
study = clearcut.study("crossover", runs=runs, generations=generations, side=10)
columns = study.columns()
level, generation, fitness = (numpy.array(columns[name]) for name in ("level", "generation", "fitness"))
names = list(dict.fromkeys(columns["level"]))
last = generation == generation.max()

figure, (boxes, curves) = plt.subplots(1, 2, figsize=(10, 4))
boxes.boxplot([fitness[last & (level == name)] for name in names], labels=names)
boxes.set_ylabel("optimum / best, per cent")
for name in names:
    steps = numpy.unique(generation[level == name])
    curves.plot(steps, [fitness[(level == name) & (generation == step)].mean() for step in steps], label=name)
curves.set_xscale("symlog")
curves.set_xlabel("generation")
curves.legend()
figure.savefig("crossover.png", dpi=120, bbox_inches="tight")
print(study.table())
