// Filters of the claims, group by group; without scripts all groups are there to be opened.
document.documentElement.classList.remove('no-script');
(function () {
  const buttons = Array.from(document.querySelectorAll('.filters button'));
  const select = document.querySelector('.filters select');
  const groups = Array.from(document.querySelectorAll('details.group'));
  const rows = Array.from(document.querySelectorAll('tr[data-verdict]'));
  const shown = document.querySelector('#claims-shown');
  const wide = window.matchMedia('(min-width: 860px)').matches;
  let verdict = '';
  function apply() {
    let count = 0;
    for (const row of rows) {
      const matches = [[verdict, row.dataset.verdict], [select.value, row.dataset.figure]].every(
        ([wanted, found]) => wanted === '' || wanted === found);
      row.hidden = !matches;
      count += matches ? 1 : 0;
    }
    for (const group of groups) {
      group.hidden = group.querySelector('tr[data-verdict]:not([hidden])') === null;
      group.open = wide || select.value !== '';
    }
    for (const button of buttons) button.setAttribute('aria-pressed', String(button.value === verdict));
    shown.textContent = count + ' of ' + rows.length + ' claims';
  }
  for (const button of buttons) {
    button.addEventListener('click', () => { verdict = button.value; apply(); });
  }
  select.addEventListener('change', apply);
  // A link to one claim must find its row, whatever is filtered or closed.
  function show() {
    const row = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (row === null) return;
    if (row.hidden) {
      verdict = '';
      select.value = '';
      apply();
    }
    row.closest('details').open = true;
    row.scrollIntoView();
  }
  window.addEventListener('hashchange', show);
  apply();
  show();
})();
