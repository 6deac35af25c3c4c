// The part of "Try an example": a plate with a pocket, four holes and its edge, as a drawing whose layers say what they are for.

/** @type {(layer: string, corners: number[][]) => string} */
const outlineOfExample = (layer, corners) => `0\nLWPOLYLINE\n8\n${layer}\n90\n${corners.length}\n70\n1\n${
  corners.map(([x, y, bulge]) => `10\n${x}\n20\n${y}\n42\n${bulge}`).join('\n')}\n`;

/** A rectangle with round corners. @type {(layer: string, x: number[], y: number[], r: number) => string} */
function roundedRectangle(layer, [x0, x1], [y0, y1], r) {
  const arc = Math.tan(Math.PI / 8);
  return outlineOfExample(layer, [
    [x0 + r, y0, 0], [x1 - r, y0, arc], [x1, y0 + r, 0], [x1, y1 - r, arc], [x1 - r, y1, 0], [x0 + r, y1, arc], [x0, y1 - r, 0],
    [x0, y0 + r, arc]
  ]);
}

function exampleDrawing() {
  const hole = (/** @type {number} */ x, /** @type {number} */ y) => `0\nCIRCLE\n8\nHOLE_D12.5\n10\n${x}\n20\n${y}\n40\n3.2\n`;
  const all = [
    roundedRectangle('PROFILE_D12', [0, 120], [0, 80], 10), roundedRectangle('POCKET_D6', [25, 95], [20, 60], 6), hole(12, 12),
    hole(108, 12), hole(108, 68), hole(12, 68)
  ];
  return `0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n${all.join('')}0\nENDSEC\n0\nEOF\n`;
}
