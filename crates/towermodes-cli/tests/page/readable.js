(() => {
  // Texts whose contrast to what is behind them is below 4.5 (WCAG 2.2, 1.4.3).
  const channels = text => (text.match(/[\d.]+/g) ?? []).map(Number);
  const luminance = ([r, g, b]) => [r, g, b]
    .map(value => value / 255)
    .map(share => share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4)
    .reduce((sum, value, i) => sum + value * [0.2126, 0.7152, 0.0722][i], 0);
  const contrast = (a, b) => {
    const [x, y] = [luminance(a), luminance(b)];
    return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
  };
  const ground = element => {
    for (let e = element; e; e = e.parentElement) {
      const color = channels(getComputedStyle(e).backgroundColor);
      if (color.length === 3 || color[3] === 1) return color;
    }
    return [255, 255, 255];
  };
  const seen = element => element.checkVisibility({ checkOpacity: true, checkVisibilityCSS: true });
  const found = [];
  for (const element of document.querySelectorAll('body *')) {
    const own = [...element.childNodes].some(node => node.nodeType === 3 && node.textContent.trim());
    if (!own || !seen(element) || ['SCRIPT', 'STYLE', 'NOSCRIPT', 'title', 'desc', 'OPTION'].includes(element.tagName)) continue;
    const style = getComputedStyle(element);
    const color = channels(element.ownerSVGElement ? style.fill : style.color);
    const ratio = contrast(color, ground(element.ownerSVGElement?.parentElement ?? element));
    if (ratio < 4.5) found.push(`${element.tagName} "${element.textContent.trim().slice(0, 30)}" ${ratio.toFixed(2)}`);
  }
  for (const field of document.querySelectorAll('input:is([type=text], [type=search])')) {
    if (!seen(field)) continue;
    for (const part of [null, '::placeholder']) {
      const ratio = contrast(channels(getComputedStyle(field, part).color), ground(field));
      if (ratio < 4.5) found.push(`INPUT${part ?? ''} "${field.value || field.placeholder}" ${ratio.toFixed(2)}`);
    }
  }
  return found;
})()
