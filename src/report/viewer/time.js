// ---- Time: where the machine is, with snapshots to go back to.
const at = { move: 0, fraction: 0, time: 0 };
const SNAPSHOTS = 16;
const snapshots = [];

function takeSnapshot() {
  const due = total * (snapshots.length + 1) / (SNAPSHOTS + 1);
  if (snapshots.length >= SNAPSHOTS || moves.t[at.move] < due) return;
  snapshots.push({ move: at.move, heights: heightContext.getImageData(0, 0, width, height) });
}

function rewind(time) {
  fullStock();
  at.move = 0; at.fraction = 0;
  for (const snapshot of snapshots) {
    if (moves.t[snapshot.move] > time || snapshot.move === 0) continue;
    at.move = snapshot.move;
    heightContext.putImageData(snapshot.heights, 0, 0);
  }
  soilAll();
}

function goTo(time) {
  time = Math.max(0, Math.min(total, time));
  if (time < at.time) rewind(time);
  while (at.move < count && moves.t[at.move + 1] <= time) {
    cut(at.move, at.fraction, 1);
    ++at.move; at.fraction = 0;
    takeSnapshot();
  }
  if (at.move < count) {
    const f = (time - moves.t[at.move]) / (moves.t[at.move + 1] - moves.t[at.move]);
    cut(at.move, at.fraction, f);
    at.fraction = f;
  }
  at.time = time;
}
