// Elements of the page: found, made and changed only where they differ.

/** The element with this id; the page has it. */
export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no element #${id}`);
  return found as T;
}

/** A new element with a class and its content. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K, className = "", ...content: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...content);
  return element;
}

export function button(text: string, onClick: () => void, className = ""): HTMLButtonElement {
  const element = make("button", className, text);
  element.type = "button";
  element.addEventListener("click", onClick);
  return element;
}

/** Sets a text if it differs, without making a new node. */
export function setText(element: Element, text: string): void {
  const first = element.firstChild;
  if (first instanceof Text && first === element.lastChild) {
    if (first.data !== text) first.data = text;
  } else if (first !== null || text !== "") element.textContent = text;
}

export function setClass(element: Element, className: string): void {
  if (element.className !== className) element.className = className;
}

/** Colours; more series begin again as rings. */
const COLOURS = 7;

/** The class of the mark of a mode in its colour. */
export function swatch(series: number): string {
  return `swatch series${series % COLOURS}${series >= COLOURS ? " second" : ""}`;
}

/** Sets an attribute if it differs; null removes it. */
export function setAttribute(element: Element, name: string, value: string | null): void {
  if (element.getAttribute(name) === value) return;
  if (value === null) element.removeAttribute(name);
  else element.setAttribute(name, value);
}

export function setHidden(element: HTMLElement, isHidden: boolean): void {
  if (element.hidden !== isHidden) element.hidden = isHidden;
}

/** Gives a list of elements a length: makes those that are missing, removes those beyond. */
export function setCount<T>(items: T[], count: number, create: (index: number) => T, remove: (item: T) => void): void {
  while (items.length > count) {
    const last = items.pop();
    if (last !== undefined) remove(last);
  }
  while (items.length < count) items.push(create(items.length));
}
