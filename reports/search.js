// Shows the lines that have all words of the search; without scripts the list of everything is shown.
(function () {
  const words = (new URLSearchParams(location.search).get('q') || '').toLowerCase().split(/\s+/).filter(Boolean);
  const field = document.querySelector('input[name=q]');
  field.value = words.join(' ');
  const lines = Array.from(document.querySelectorAll('.search li'));
  let count = 0;
  for (const line of lines) {
    const text = line.textContent.toLowerCase();
    line.hidden = !words.every((word) => text.includes(word));
    count += line.hidden ? 0 : 1;
  }
  document.getElementById('search-shown').textContent = words.length === 0
    ? lines.length + ' entries' : count + ' of ' + lines.length + ' entries have "' + words.join(' ') + '"';
})();
