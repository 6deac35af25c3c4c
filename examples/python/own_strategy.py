"""A strategy of one's own in Python, linked and certified like those of the software, and held against them."""
import clearcut


def rings(layer: clearcut.Layer) -> clearcut.LayerPasses:
    """Contours at half the cutter's radius from one another, from the walls to the middle."""
    if not layer.closed_all_round:
        raise clearcut.InputError("rings: fills closed pockets alone")
    area = layer.clearing_area()  # where the tool's centre may be, and passes along the walls
    passes = area.walls

    def add(region: clearcut.Region, parent: int, component: int) -> None:
        for ring in clearcut.inset(region, 0.5 * layer.tool_radius):
            outer = passes.add(ring.outer, parent=parent, component=component)
            for island in ring.islands:
                passes.add(island, parent=parent, component=component)
            add(ring, outer, component)

    for number, component in enumerate(area.components):
        add(component.legal, component.outer_wall, number)
    return passes


part = clearcut.part([[0, 0], [60, 0], [60, 40], [30, 40], [30, 25], [0, 25]], depth=4, name="pocket")
own = clearcut.Strategy("rings", rings, "contours at half the radius, to the middle")
for name in ("rings", "contour"):
    plan = clearcut.plan(part, tools="endmill:6", strategy=name, strategies=[own])
    figures = plan.findings.all
    print(f"{name:8} {plan.verdict:6} {figures.feed_mm:7.0f} mm {figures.time_s:6.1f} s")
