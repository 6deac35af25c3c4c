// A widget for senders whose pages hand programs to widgets by events, as CNCjs and gSender do: it checks each program that is loaded, before
// it runs. The host is an object with addListener(event, listener), removeListener, command(name) and settings.
'use strict';

(function(root, factory) {
if (typeof module === 'object' && module.exports) module.exports = factory();
else root.clearcutWidget = factory();
})(typeof self === 'undefined' ? globalThis : self, () => {
/** Name and text of a program, from the arguments of gcode:load (CNCjs 1, gSender) or sender:load (CNCjs 2). */
function programOf(first, second) {
  if (typeof first === 'object' && first !== null) return {name: first.name || 'program', text: first.content || first.gcode || ''};
  return {name: first || 'program', text: second || ''};
}

/** Grbl's settings as its own listing, which the check reads as a machine; '' for a control that has sent none. */
function machineText(settings) {
  const values = (settings && settings.settings) || {};
  const names = Object.keys(values).filter((name) => /^\$\d+$/.test(name));
  return names.map((name) => name + '=' + values[name] + '\n').join('');
}

/** Lines for a person: the verdict, then each fault and each open condition. */
function linesOf(answer) {
  if (answer.error) return {verdict: 'NOT CHECKED', lines: [answer.error]};
  const line = (one) => (one.line ? 'line ' + one.line + ': ' : '') + one.text;
  return {verdict: answer.verdict, lines: answer.faults.concat(answer.conditions).map(line)};
}

/**
   * Starts a widget. `host`: the sender's controller. `verifier`: from createVerifier(). `question`: returns what is asked of a program
   * besides its name (tools, stock, ...). `show`: called with {verdict, lines}. `holdFaulty`: a program whose verdict is
   * neither CLEAN nor CONDITIONAL is paused as soon as the sender starts it.
   */
function startWidget({host, verifier, question, show, holdFaulty = false}) {
  let loaded = null;
  let shown = {verdict: '', lines: []};

  function ask() {
    if (!loaded) return;
    const asked = Object.assign({name: loaded.name, dialect: 'grbl'}, question());
    const machine = machineText(host.settings);
    if (machine && !asked.machine) asked.machine = machine;
    shown = linesOf(JSON.parse(verifier.check(loaded.text, JSON.stringify(asked))));
    show(shown);
  }

  function load(first, second) {
    loaded = programOf(first, second);
    ask();
  }

  function unload() {
    loaded = null;
    shown = {verdict: '', lines: []};
    show(shown);
  }

  function workflow(state) {
    const isHeld = loaded && !/^(CLEAN|CONDITIONAL)\b/.test(shown.verdict);
    if (holdFaulty && state === 'running' && isHeld) host.command('gcode:pause');
  }

  const listeners = {
    'gcode:load': load,
    'sender:load': load,
    'gcode:unload': unload,
    'sender:unload': unload,
    'controller:settings': ask,
    'workflow:state': workflow
  };
  for (const [event, listener] of Object.entries(listeners)) host.addListener(event, listener);

  /** Leaves the host as it was. */
  function stop() {
    for (const [event, listener] of Object.entries(listeners)) host.removeListener(event, listener);
  }
  return {ask, stop};
}

return {startWidget};
});
