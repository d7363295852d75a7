// Filters of the claims table; without scripts the whole table is shown.
document.documentElement.classList.remove('no-script');
(function () {
  const buttons = Array.from(document.querySelectorAll('.filters button'));
  const select = document.querySelector('.filters select');
  const rows = Array.from(document.querySelectorAll('#claim-rows tr'));
  const shown = document.querySelector('#claims-shown');
  let verdict = '';
  function apply() {
    let count = 0;
    for (const row of rows) {
      const matches = [[verdict, row.dataset.verdict], [select.value, row.dataset.figure]].every(
        ([wanted, found]) => wanted === '' || wanted === found);
      row.hidden = !matches;
      count += matches ? 1 : 0;
    }
    for (const button of buttons) button.setAttribute('aria-pressed', String(button.value === verdict));
    shown.textContent = count + ' of ' + rows.length + ' claims';
  }
  for (const button of buttons) {
    button.addEventListener('click', () => { verdict = button.value; apply(); });
  }
  select.addEventListener('change', apply);
  // A link to one claim must find its row, whatever is filtered.
  window.addEventListener('hashchange', () => {
    const row = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (row === null || row.hidden === false) return;
    verdict = '';
    select.value = '';
    apply();
    row.scrollIntoView();
  });
  apply();
})();
