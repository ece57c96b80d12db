// All numbers of the tower as sliders, in groups that fold, with a search.

import { byId, make, setClass, setHidden, setText } from "../dom.js";
import { movedBy } from "../numbers/followers.js";
import { baseAmong, isMultiplied, multiplied, type Base } from "../numbers/column.js";
import type { Elasticities, Group, NoElasticity, Parameter, Sheet, TargetVariable } from "../protocol.js";
import { Row } from "./row.js";

export interface ParameterEvents {
  /** The user asks for these values by the slider with a key: a number or a column. */
  input(numbers: Record<string, number>, key: string): void;
  /** The slide or the typing is at its end; the key says of what. */
  settle(key: string): void;
  /** Another group is open: its elasticities are wanted. */
  opened(): void;
}

interface Entry {
  parameter: Parameter;
  index: number;
  row: Row;
  /** The names of all numbers that the slider moves. */
  moved: string[];
  words: string;
}

interface Column {
  /** `stations[*].wall`. */
  name: string;
  row: Row;
  indices: number[];
  /** What the factor multiplies while it is being slid. */
  base: Base | null;
  /** What the last factor has multiplied. */
  last: number[] | null;
  words: string;
}

interface Section {
  group: Group;
  element: HTMLDetailsElement;
  mark: HTMLElement;
  entries: Entry[];
  columns: Column[];
}

export class ParameterPanel {
  private sections: Section[];
  private values: number[] = [];
  private elasticities: Record<string, number> = {};
  /** Of factors on columns, by their names. */
  private factors: Record<string, number> = {};
  private reasons: Record<string, NoElasticity> = {};
  private largest = 0;
  private refused = new Set<string>();
  private refusal = "";
  private query = "";
  /** Groups that the search has opened. */
  private opened = new Set<Section>();

  constructor(private sheet: Sheet, private events: ParameterEvents) {
    this.sections = sheet.groups.map((group, index) => this.section(group, index));
    byId("groups").append(...this.sections.map(({ element }) => element));
    const filter = byId<HTMLInputElement>("filter");
    filter.addEventListener("input", () => this.search(filter.value));
  }

  private section(group: Group, index: number): Section {
    const mark = make("span", "mark");
    const title = make("span", "group-title", group.title.charAt(0).toUpperCase() + group.title.slice(1));
    const summary = make("summary", "", title, make("code", "", group.name), mark);
    const element = make("details", "group", summary);
    element.setAttribute("aria-label", group.title);
    const section: Section = { group, element, mark, entries: [], columns: [] };
    section.columns = group.columns.map((name, place) => this.column(section, name, `column-${index}-${place}`));
    this.sheet.parameters.forEach((parameter, place) => {
      if (parameter.group === index && parameter.follows === null) section.entries.push(this.entry(parameter, place));
    });
    section.columns = section.columns.filter(({ indices }) => indices.length > 1);
    // A column of which all numbers are zero or rigid has a slider that does nothing: it comes last.
    const isMoved = ({ indices }: Column): boolean => indices.some((index) => isMultiplied(this.sheet.parameters[index]?.value ?? 0));
    const rows = (of: { row: Row }[]): HTMLElement[] => of.map(({ row }) => row.element);
    const still = section.columns.filter((column) => !isMoved(column));
    element.append(...rows(section.columns.filter(isMoved)), ...rows(section.entries), ...rows(still));
    element.addEventListener("toggle", () => {
      if (!element.open) return;
      this.showSection(section);
      this.events.opened();
    });
    return section;
  }

  private entry(parameter: Parameter, index: number): Entry {
    const { name, label, meaning, unit, low, high, value } = parameter;
    const row = new Row({ id: `number-${index}`, name, label, meaning, unit }, { low, high, home: value }, {
      input: (value) => this.events.input({ [name]: value }, name),
      settle: () => this.events.settle(name),
    });
    const moved = movedBy(this.sheet.parameters, index).map((place) => this.sheet.parameters[place]?.name ?? "");
    return { parameter, index, row, moved, words: `${moved.join(" ")} ${meaning} ${label}`.toLowerCase() };
  }

  private column(section: Section, name: string, id: string): Column {
    const key = name.slice(name.lastIndexOf(".") + 1);
    const { parameters } = this.sheet;
    const own = parameters.filter(({ column }) => column === name);
    // What a slider of several numbers is called is not the name of the column.
    const plain = own.find((one) => !parameters.some(({ follows }) => follows !== null && parameters[follows] === one));
    const meaning = plain?.meaning ?? key;
    const of = parameters.flatMap(({ column, also_in }, index) => (column === name || also_in === name ? [index] : []));
    const column: Column = { name, row: undefined as never, indices: of, base: null, last: null, words: `${name} ${meaning} ${section.group.title}`.toLowerCase() };
    column.row = new Row({ id, name, label: `every ${meaning}\u00a0×`, meaning: "", unit: "" }, { low: 0.5, high: 1.5, home: 1 }, {
      input: (factor) => this.multiply(column, factor),
      settle: () => {
        column.base = null;
        this.events.settle(name);
      },
    });
    column.row.element.classList.add("column");
    return column;
  }

  private multiply(column: Column, factor: number): void {
    column.base ??= this.base(column);
    column.last = column.base.values;
    const values = multiplied(column.base, factor);
    const names = column.indices.map((index) => this.sheet.parameters[index]?.name ?? "");
    this.events.input(Object.fromEntries(names.map((name, k) => [name, values[k] ?? 0])), column.name);
  }

  private base({ indices, last }: Column): Base {
    const ofFile = indices.map((index) => this.sheet.parameters[index]?.value ?? 0);
    const earlier = last === null ? [ofFile] : [ofFile, last];
    return baseAmong(earlier, indices.map((index) => this.values[index] ?? 0));
  }

  /** Shows the present values, in the order of the sheet. */
  show(values: number[]): void {
    this.values = values;
    for (const section of this.sections) {
      if (section.element.open) this.showSection(section);
      else this.showMark(section);
    }
  }

  private showSection(section: Section): void {
    for (const { row, index, parameter, moved } of section.entries) {
      row.show(this.values[index] ?? parameter.value);
      row.refuse(this.isRefused(moved) ? this.refusal : null);
      row.elasticity(this.elasticities[parameter.name] ?? null, this.largest, this.reasons[parameter.name] ?? null);
    }
    for (const column of section.columns) this.showColumn(column);
    this.showMark(section);
  }

  private showColumn(column: Column): void {
    // While it is slid, the factor is the user's.
    if (column.base === null) {
      const { values, factor } = this.base(column);
      column.row.enable(values.some(isMultiplied));
      column.row.show(factor);
    }
    column.row.refuse(this.isRefused([column.name]) ? this.refusal : null);
    column.row.elasticity(this.factors[column.name] ?? null, this.largest, this.reasons[column.name] ?? null);
  }

  private isRefused(names: string[]): boolean {
    return names.some((name) => this.refused.has(name));
  }

  /** What a closed group has to say. */
  private showMark({ mark, entries, columns }: Section): void {
    const isRefused = this.isRefused([...entries.flatMap(({ moved }) => moved), ...columns.map(({ name }) => name)]);
    const changed = entries.filter(({ parameter, index }) => (this.values[index] ?? parameter.value) !== parameter.value).length;
    setText(mark, isRefused ? "refused" : changed > 0 ? `${changed} changed` : "");
    setClass(mark, isRefused ? "mark refused" : "mark");
  }

  /** The numbers and columns that a refusal is about, with what it says. */
  refuse(names: string[], message: string): void {
    this.refused = new Set(names);
    this.refusal = message;
  }

  /** Shows elasticities, beside those that are known. */
  addElasticities({ elasticities, columns, reasons }: Elasticities): void {
    const without = <T>(all: Record<string, T>, names: object): Record<string, T> =>
      Object.fromEntries(Object.entries(all).filter(([name]) => !(name in names)));
    this.elasticities = { ...without(this.elasticities, reasons), ...elasticities };
    this.factors = { ...without(this.factors, reasons), ...columns };
    this.reasons = { ...without(without(this.reasons, elasticities), columns), ...reasons };
    this.showAll();
  }

  clearElasticities(): void {
    [this.elasticities, this.factors, this.reasons] = [{}, {}, {}];
    this.showAll();
  }

  /** The names of numbers and columns in open and in closed groups. */
  names(): { shown: string[]; hidden: string[] } {
    const names = (isOpen: boolean): string[] => this.sections.filter(({ element }) => element.open === isOpen)
      .flatMap(({ columns, entries }) => [...columns.map(({ name }) => name), ...entries.map(({ parameter }) => parameter.name)]);
    return { shown: names(true), hidden: names(false) };
  }

  private showAll(): void {
    const { elasticities, factors } = this;
    this.largest = Math.max(0, ...[...Object.values(elasticities), ...Object.values(factors)].map(Math.abs));
    for (const section of this.sections) if (section.element.open) this.showSection(section);
  }

  /** The names of the groups that are open. */
  open(): string[] {
    return this.sections.filter((section) => section.element.open && !this.opened.has(section)).map(({ group }) => group.name);
  }

  /** Opens these groups. */
  unfold(names: string[]): void {
    for (const { group, element } of this.sections) if (names.includes(group.name)) element.open = true;
  }

  /** Shows the boxes that let a search change a number; at first all wall thicknesses, or else all
   * bending stiffnesses, are marked. */
  mark(isOn: boolean): void {
    document.body.classList.toggle("is-marking", isOn);
    if (!isOn || this.marked().length > 0) return;
    const columns = this.sections.flatMap((section) => section.columns.map((column) => ({ section, column })));
    const usual = /\.(wall|ei_fore_aft_n_m2|ei_side_side_n_m2)$/;
    for (const { section, column } of columns.filter(({ column }) => usual.test(column.name))) {
      column.row.isMarked = true;
      section.element.open = true;
    }
  }

  /** What a search may change, with the ends of the sliders. */
  marked(): TargetVariable[] {
    return this.sections.flatMap(({ columns, entries }) => [
      ...columns.filter(({ row }) => row.isMarked).map(({ name, row }) => ({ name: `scale(${name})`, ...row.ends })),
      ...entries.filter(({ row }) => row.isMarked).map(({ parameter, row }) => ({ name: parameter.name, ...row.ends })),
    ]);
  }

  /** Why a search cannot change all that is marked: a number is marked alone and in its column. */
  conflict(): string | null {
    for (const { columns } of this.sections) {
      for (const column of columns.filter(({ row }) => row.isMarked)) {
        const names = column.indices.map((index) => this.sheet.parameters[index]?.name ?? "");
        const entries = this.sections.flatMap((section) => section.entries);
        const twice = entries.find(({ row, moved }) => row.isMarked && moved.some((name) => names.includes(name)));
        if (twice) return `“${column.row.heading}” changes “${twice.row.heading}” too: untick one of them.`;
      }
    }
    return null;
  }

  /** A sentence of the program in the words of the page: names in backticks become labels. */
  inWords(text: string): string {
    const rows = new Map<string, string>(this.sections.flatMap(({ columns, entries }) => [
      ...columns.map(({ name, row }): [string, string] => [name, row.heading]),
      ...entries.map(({ parameter, row }): [string, string] => [parameter.name, row.heading]),
    ]));
    return text.replace(/`(?:[a-z]+\()?([^`,)]+)[^`]*`/g, (written, name: string) => {
      const heading = rows.get(name);
      return heading === undefined ? written : `“${heading}”`;
    });
  }

  /** Leads to the field of a number, also if the search has hidden it. */
  reveal(name: string): void {
    const filter = byId<HTMLInputElement>("filter");
    filter.value = "";
    this.search("");
    for (const { element, entries } of this.sections) {
      const entry = entries.find(({ moved }) => moved.includes(name));
      if (entry === undefined) continue;
      element.open = true;
      entry.row.focus();
    }
  }

  /** The group with the number of the largest elasticity. */
  mostInfluential(): string | null {
    const size = (name: string): number => Math.abs(this.elasticities[name] ?? 0);
    const most = this.sheet.parameters.reduce<Parameter | null>(
      (best, parameter) => (size(parameter.name) > (best ? size(best.name) : 0) ? parameter : best), null);
    return (most && this.sheet.groups[most.group]?.name) ?? null;
  }

  private search(query: string): void {
    this.query = query.trim().toLowerCase();
    const words = this.query.split(/\s+/);
    const fits = (text: string): boolean => words.every((word) => text.includes(word));
    let found = 0;
    for (const section of this.sections) {
      const { entries, columns, element, group } = section;
      const title = `${group.title} ${group.name} `.toLowerCase();
      for (const { row, words } of [...entries, ...columns]) setHidden(row.element, !fits(title + words));
      const count = entries.filter(({ row }) => !row.element.hidden).length;
      found += count;
      setHidden(element, count === 0);
      this.openForSearch(section, count > 0);
    }
    setText(byId("filter-text"), this.query === "" ? "" : found === 0 ? "No input value has these words in its name or meaning." : `${found} found.`);
  }

  /** Groups that the search opens are closed after it. */
  private openForSearch(section: Section, isFound: boolean): void {
    if (this.query !== "" && isFound && !section.element.open) {
      this.opened.add(section);
      section.element.open = true;
    } else if (this.query === "" && this.opened.delete(section)) section.element.open = false;
  }
}
