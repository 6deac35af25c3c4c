// Searches the sections that search-index.js lists; a page opened from disk may fetch nothing, so both are plain scripts.
'use strict';
const field = document.getElementById('search-words');
const list = document.getElementById('search-found');

function found(words) {
  const matches = [];
  for (const [page, anchor, title, text] of window.SEARCH_INDEX) {
    const all = `${title} ${text}`.toLowerCase();
    if (!words.every((word) => all.includes(word))) continue;
    const inTitle = words.filter((word) => title.toLowerCase().includes(word)).length;
    matches.push({page, anchor, title, text, inTitle, at: Math.max(0, text.toLowerCase().indexOf(words[0]) - 60)});
  }
  return matches.sort((a, b) => b.inTitle - a.inTitle).slice(0, 40);
}

function show() {
  const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
  list.replaceChildren(...(words.length ? found(words) : []).map((match) => {
    const item = document.createElement('li');
    const link = document.createElement('a');
    link.href = `${match.page}${match.anchor ? '#' : ''}${match.anchor}`;
    link.textContent = match.title;
    item.append(link, ` … ${match.text.slice(match.at, match.at + 160)} …`);
    return item;
  }));
}

field.addEventListener('input', show);
field.value = decodeURIComponent(location.hash.slice(1));
show();
