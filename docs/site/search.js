// Searches the pages: sections that have all words, those first whose heading has them, and that are in the page's language. Works without a server, and fetches nothing.
(function () {
  const root = document.currentScript.dataset.root;
  const plain = text => text.toLowerCase().normalize('NFD').replace(/[\u0300-\u036f]/g, '');
  const cs = location.pathname.includes('/cs/');
  function begin() {
    const box = document.createElement('form');
    box.id = 'search';
    box.setAttribute('role', 'search');
    const field = document.createElement('input');
    field.type = 'search';
    field.placeholder = cs ? 'Hledat' : 'Search';
    field.setAttribute('aria-label', field.placeholder);
    const list = document.createElement('ul');
    box.append(field, list);
    document.body.prepend(box);
    box.addEventListener('submit', event => {
      event.preventDefault();
      const first = list.querySelector('a');
      if (first) { first.click(); }
    });
    const show = () => {
      list.replaceChildren();
      const words = plain(field.value).split(/\s+/).filter(Boolean);
      if (!words.length) { return; }
      const found = [];
      for (const [link, title, heading, text] of window.PAPRSEK_PAGES) {
        const all = plain(text), head = plain(heading + ' ' + title);
        if (words.every(word => all.includes(word) || head.includes(word))) {
          found.push({link, title, heading, text, rank: (link.includes('/cs/') === cs ? 100 : 0) + words.reduce((sum, word) => sum + (head.includes(word) ? 10 : 0) + Math.min(9, all.split(word).length - 1), 0)});
        }
      }
      found.sort((a, b) => b.rank - a.rank);
      for (const one of found.slice(0, 12)) {
        const item = document.createElement('li'), a = document.createElement('a'), some = document.createElement('small');
        a.href = root + '/' + one.link;
        a.textContent = one.title + (one.heading && one.heading !== one.title ? ': ' + one.heading : '');
        const at = Math.max(0, plain(one.text).indexOf(words[0]) - 30);
        some.textContent = one.text.slice(at, at + 90);
        item.append(a, some);
        list.append(item);
      }
      if (!found.length) {
        const none = document.createElement('li');
        none.textContent = cs ? 'Nic takového tu není.' : 'There is nothing like that.';
        list.append(none);
      }
    };
    field.addEventListener('input', show);
    const asked = new URLSearchParams(location.search).get('q');
    if (asked) { field.value = asked; show(); }
  }
  if (document.readyState === 'loading') { document.addEventListener('DOMContentLoaded', begin); } else { begin(); }
})();
