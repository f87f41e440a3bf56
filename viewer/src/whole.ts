// SPDX-License-Identifier: MIT
/** Says that the end of a page is missing, as after a download that broke off. It stands before all else. */
document.addEventListener('DOMContentLoaded', () => {
  if (document.getElementById('end')) return;
  const said = Object.assign(document.createElement('div'), { className: 'failure', role: 'alert' });
  said.append(Object.assign(document.createElement('h1'), { textContent: 'This page is not whole' }), 'Its end is missing, as after a download that broke off: get it once more.');
  document.body.replaceChildren(said);
});
