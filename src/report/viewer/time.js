// ---- Time: where the machine is, with snapshots to go back to.
const at = {
  move: 0,
  fraction: 0,
  time: 0
};
const SNAPSHOTS = 16;
/** @type {Snapshot[]} */
const snapshots = [];

function takeSnapshot() {
  const due = total * (snapshots.length + 1) / (SNAPSHOTS + 1);
  if (snapshots.length >= SNAPSHOTS || moves.t[at.move] < due) return;
  snapshots.push({move: at.move, heights: heights.slice()});
}

/** @type {(time: number) => void} */
function rewind(time) {
  const snapshot = snapshots.findLast(one => moves.t[one.move] <= time && one.move > 0);
  fullStock();
  at.move = 0;
  at.fraction = 0;
  if (snapshot) {
    at.move = snapshot.move;
    heights.set(snapshot.heights);
  }
  soilAll();
}

/** The heights are those of all whole moves up to then and of the part of the one under way: the same from either side. @type {(time: number) => void} */
function goTo(time) {
  time = Math.max(0, Math.min(total, time));
  if (time < at.time) rewind(time);
  if (at.move < count && moves.t[at.move + 1] <= time) putBack();
  while (at.move < count && moves.t[at.move + 1] <= time) {
    cut(at.move, 0, 1);
    ++at.move;
    at.fraction = 0;
    takeSnapshot();
  }
  if (at.move < count) {
    at.fraction = (time - moves.t[at.move]) / (moves.t[at.move + 1] - moves.t[at.move]);
    cutPart(at.move, at.fraction);
  }
  at.time = time;
}
