// The way to the pipeline, by a server. The page without a server has the same functions (apps/web/page/local.js).

/** The answer as JSON; throws an Error with the server's own words. @template Answer @param {string} path @param {RequestInit} [request] @returns {Promise<Answer>} */
async function asked(path, request) {
  const answer = await fetch(path, request).catch(() => {
    throw new Error('The server does not answer. Is it still running?');
  });
  const json = await answer.json().catch(() => ({}));
  if (!answer.ok) throw new Error(json.error || `The server answers ${answer.status}.`);
  return json;
}

/** See Pipeline for what each does. @type {Pipeline} */
const pipeline = {
  promise: '',
  noSolids: '',
  options: () => asked('/options'),
  begin: async (what, form) => (await asked(`/${what}`, {method: 'POST', body: form})).id,
  drop: id => asked(`/plan/${id}`, {method: 'DELETE'}).catch(() => {}),
  follow(id, hear, broken) {
    /** @type {EventSource | null} */
    let events = null;
    let isOver = false;
    const ask = async () => {
      events?.close();
      try {
        /** @type {WorkState} */
        const state = await asked(`/plan/${id}`);
        if (!isOver) hear(state);
        if (!isOver) setTimeout(open, 1000);
      } catch (error) {
        if (!isOver) broken(new Error(wordsOfError(error)));
      }
    };
    const open = () => {
      if (isOver) return;
      events = new EventSource(`/plan/${id}/events`);
      events.onmessage = event => hear(JSON.parse(event.data));
      events.onerror = ask;
    };
    open();
    return () => {
      isOver = true;
      events?.close();
    };
  },
  info: form => asked('/info', {method: 'POST', body: form}),
};
