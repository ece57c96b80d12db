// Changes a drawing in the page into another one by touching only what differs: laying out texts
// again is slow.

/** Reads SVG in half the time of a parser for XML. */
const template = document.createElement("template");

/** Shows an SVG in an element. */
export function showSvg(host: HTMLElement, svg: string): void {
  template.innerHTML = svg;
  const next = template.content.firstElementChild;
  const present = host.firstElementChild;
  if (next === null) return;
  if (present !== null && present.nodeName === next.nodeName) patch(present, next);
  else host.replaceChildren(document.adoptNode(next));
}

/** Makes an element equal to another of the same name. */
function patch(present: Element, next: Element): void {
  for (const { name, value } of next.attributes) if (present.getAttribute(name) !== value) present.setAttribute(name, value);
  if (present.attributes.length > next.attributes.length) {
    for (const { name } of [...present.attributes]) if (!next.hasAttribute(name)) present.removeAttribute(name);
  }
  let old = present.firstChild;
  let fresh = next.firstChild;
  while (fresh !== null) {
    const following: ChildNode | null = fresh.nextSibling;
    if (old !== null && isAlike(old, fresh)) {
      patchNode(old, fresh);
      old = old.nextSibling;
    } else {
      // A drawing that has one element more or less: what follows is alike again.
      const later = old?.nextSibling ?? null;
      if (old !== null && later !== null && isAlike(later, fresh)) {
        old.remove();
        patchNode(later, fresh);
        old = later.nextSibling;
      } else present.insertBefore(document.adoptNode(fresh), old);
    }
    fresh = following;
  }
  while (old !== null) {
    const following: ChildNode | null = old.nextSibling;
    old.remove();
    old = following;
  }
}

function isAlike(a: Node, b: Node): boolean {
  return a.nodeName === b.nodeName;
}

function patchNode(present: Node, next: Node): void {
  if (present instanceof Element && next instanceof Element) patch(present, next);
  else if (present.nodeValue !== next.nodeValue) present.nodeValue = next.nodeValue;
}
