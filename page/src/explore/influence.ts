// The elasticities of the mode that is shown: asked for when nothing else is to be answered.

import { byId, setText } from "./dom.js";
import type { ParameterPanel } from "./panels/parameters.js";
import { elasticities } from "./program/program.js";
import type { State } from "./protocol.js";

/** Shows the influence of each number on a mode, beside its slider. */
export class Influence {
  /** The question whose answer is shown or on its way. */
  private asked = "";
  private isAsking = false;

  constructor(
    private panel: ParameterPanel,
    private failed: (error: unknown) => void,
    /** Asks again, if there is another question by then. */
    private done: () => void,
  ) {}

  get pending(): boolean {
    return this.isAsking;
  }

  /** Asks for a mode of a state by its number, unless that is what is shown. */
  ask(state: State, mode: number): void {
    const question = JSON.stringify([state, mode]);
    if (this.isAsking || question === this.asked) return;
    this.asked = question;
    this.isAsking = true;
    void this.fetch(state, mode).catch(this.failed).finally(() => {
      this.isAsking = false;
      this.done();
    });
  }

  private async fetch(state: State, mode: number): Promise<void> {
    const result = await elasticities(state, mode);
    if (result.refused !== null) return;
    const text = byId("elasticity-text");
    const isFirst = text.textContent === "";
    setText(text, `Elasticity of ${result.mode}, % per %`);
    this.panel.showElasticities(result.elasticities, result.columns);
    const group = this.panel.mostInfluential();
    if (isFirst && group !== null && this.panel.open().length === 0) this.panel.unfold([group]);
  }
}
