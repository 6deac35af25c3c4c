// ---- Reports side by side: a page around several of them ("#linked" in the address) hands camera, section and time from one to the others.
/** What was told or taken last is not told again. */
const link = {
  on: false,
  look: '',
  time: -1
};

/** @type {(message: ReportMessage) => void} */
const tell = message => window.parent.postMessage(message, '*');

/** @type {() => Look} */
const lookNow = () => ({
  space: space.on,
  camera: [camera.x, camera.y, camera.z, camera.k, camera.yaw, camera.pitch],
  flat: [view.x, view.y, view.k],
  section: section.axis,
  sectionAt: Number(by('section-at').value)
});

/** @type {(values: unknown, size: number) => boolean} */
const areNumbers = (values, size) => Array.isArray(values) && values.length === size && values.every(Number.isFinite);

/** Only what a report itself would say: whoever has put the page into a frame may say anything. @type {(look: Look) => boolean} */
const isLook = look => typeof look === 'object' && look !== null && areNumbers(look.camera, 6) && areNumbers(look.flat, 3) &&
  look.camera[3] > 0 && look.flat[2] > 0 && ['none', 'x', 'y', 'z'].includes(look.section) && Number.isFinite(look.sectionAt);

/** @type {(look: Look) => void} */
function takeLook(look) {
  if (look.space !== space.on) chooseView(look.space ? 'iso' : 'above');
  [camera.x, camera.y, camera.z, camera.k, camera.yaw, camera.pitch] = look.camera;
  [view.x, view.y, view.k] = look.flat;
  camera.fitted = fitted = false;
  by('section').value = look.section;
  by('section-at').value = String(look.sectionAt);
  chooseSection(true);
  markStandpoint();
  link.look = JSON.stringify(lookNow());
}

/** @type {(order: ReportOrder) => void} */
function heed(order) {
  if (order.clearcut === 'ask') tell({clearcut: 'look', look: lookNow()});
  else if (order.clearcut === 'look' && isLook(order.look)) takeLook(order.look);
  else if (order.clearcut === 'time' && Number.isFinite(order.time)) {
    play(false);
    link.time = Math.max(0, Math.min(total, order.time));
    show(order.time);
    tell({clearcut: 'shown'});
  }
}

/** After each drawing. */
function tellChanges() {
  if (!link.on) return;
  const look = lookNow(), key = JSON.stringify(look);
  if (key !== link.look) tell({clearcut: 'look', look});
  if (at.time !== link.time) tell({clearcut: 'time', time: at.time});
  link.look = key;
  link.time = at.time;
}

/** The page around it has the controls; here are the part and what is seen of it. @type {() => boolean} */
function beLinked() {
  if (window.parent === window || !new URLSearchParams(location.hash.slice(1)).has('linked')) return false;
  document.body.classList.add('linked');
  redraw();
  link.look = JSON.stringify(lookNow());
  link.time = at.time;
  link.on = true;
  window.addEventListener('message', event => {
    if (event.source === window.parent && typeof event.data === 'object' && event.data !== null) heed(event.data);
  });
  tell({clearcut: 'ready', total});
  return true;
}
