(() => {
  // Texts of pictures that reach beyond them, by the fonts that are here.
  const found = [];
  for (const svg of document.querySelectorAll('svg[role=img], #animation svg')) {
    const paper = svg.getBoundingClientRect();
    if (paper.width === 0) continue;
    for (const text of svg.querySelectorAll('text')) {
      const box = text.getBoundingClientRect();
      const slack = 0.5;
      if (box.left < paper.left - slack || box.right > paper.right + slack || box.top < paper.top - slack || box.bottom > paper.bottom + slack) {
        found.push(`${svg.id || svg.querySelector('title')?.textContent}: "${text.textContent}"`);
      }
    }
  }
  return found;
})()
