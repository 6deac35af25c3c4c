// The way to the pipeline, by a server. The page without a server has the same functions (apps/web/page/local.js).

/** The answer as JSON; throws an Error with the server's own words. */
async function asked(path, request) {
  const answer = await fetch(path, request).catch(() => { throw new Error('The server does not answer. Is it still running?'); });
  const json = await answer.json().catch(() => ({}));
  if (!answer.ok) throw new Error(json.error || `The server answers ${answer.status}.`);
  return json;
}

const pipeline = {
  /** What happens to files, where it is not what the page says. */
  promise: '',
  options: () => asked('/options'),
  /** Begins a plan; gives its name. */
  plan: async form => (await asked('/plan', { method: 'POST', body: form })).id,
  /** Ends a plan and forgets it. */
  drop: id => asked(`/plan/${id}`, { method: 'DELETE' }).catch(() => {}),
  /** Calls `hear` with each state of a plan until its last, `broken` where none comes any more. Gives what ends that. */
  follow(id, hear, broken) {
    let events = null, isOver = false;
    const ask = async () => {
      events.close();
      try {
        const state = await asked(`/plan/${id}`);
        if (!isOver) hear(state);
        if (!isOver) setTimeout(open, 1000);
      } catch (error) {
        if (!isOver) broken(error);
      }
    };
    const open = () => {
      if (isOver) return;
      events = new EventSource(`/plan/${id}/events`);
      events.onmessage = event => hear(JSON.parse(event.data));
      events.onerror = ask;
    };
    open();
    return () => { isOver = true; events.close(); };
  },
  /** Checks a program; gives its last state with certificate and text. */
  check: form => asked('/check', { method: 'POST', body: form }),
  /** What a part holds. */
  info: form => asked('/info', { method: 'POST', body: form }),
  /** Every strategy on a part. */
  compare: form => asked('/compare', { method: 'POST', body: form }),
};
