"""A first pocket: from an outline to a program that is proven, in ten lines."""
import clearcut

outline = [[0, 0], [60, 0], [60, 40], [30, 40], [30, 25], [0, 25]]
part = clearcut.part(outline, depth=4, name="first")
plan = clearcut.plan(part, tools="endmill:6", feed=900)
print(plan.table())
if plan.clean:
    plan.write("first.ngc", certificate="first.json", picture="first.svg", page="first.html")
