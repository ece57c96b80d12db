// The explorer as WebAssembly: one instance has one tower.

/** A file by its name without folders. */
export interface NamedFile {
  name: string;
  content: Uint8Array<ArrayBuffer>;
}

/** What the module exports: see crates/towermodes-web/src/interface.rs. */
interface Exports {
  memory: WebAssembly.Memory;
  begin(): void;
  room(length: number): number;
  answer(): number;
  answer_length(): number;
  put(nameLength: number): number;
  open(): number;
  ask(nameLength: number): number;
  colours(): number;
}

/** What an answer is. */
export enum Kind {
  Json = 0,
  /** A file: the lines of its name and of its media type, then its content. */
  File = 1,
  /** No file, with the refusal of the tower in JSON. */
  Refused = 2,
  /** Why there is no such answer. */
  Message = 3,
}

export interface Answer {
  kind: Kind;
  content: Uint8Array<ArrayBuffer>;
}

/** The files are not those of one tower. */
export class NoTower extends Error {}

/** The module ended in the middle of a call and cannot be called again. */
export class Failed extends Error {}

const toBytes = new TextEncoder();
const toText = new TextDecoder();

export class Solver {
  private panic = "";

  private constructor(private exports: Exports) {}

  /** An instance without a tower. */
  static async start(module: WebAssembly.Module): Promise<Solver> {
    let solver: Solver | null = null;
    const instance = await WebAssembly.instantiate(module, {
      page: {
        now_ms: () => performance.now(),
        failed: (address: number, length: number) => {
          if (solver !== null) solver.panic = toText.decode(solver.bytes(address, length));
        },
      },
    });
    solver = new Solver(instance.exports as unknown as Exports);
    solver.exports.begin();
    return solver;
  }

  /** An instance with the tower of files. */
  static async open(module: WebAssembly.Module, files: NamedFile[]): Promise<Solver> {
    const solver = await Solver.start(module);
    const done = [
      ...files.map(({ name, content }) => solver.call((length) => solver.exports.put(length), name, content)),
      solver.call(() => solver.exports.open(), "", new Uint8Array()),
    ];
    const wrong = done.find(({ kind }) => kind !== Kind.Json);
    if (wrong) throw new NoTower(toText.decode(wrong.content));
    return solver;
  }

  ask(question: string, body: object | null): Answer {
    const text = toBytes.encode(body === null ? "" : JSON.stringify(body));
    return this.call((length) => this.exports.ask(length), question, text);
  }

  /** The style sheet with the colours of the page. */
  colours(): string {
    return toText.decode(this.call(() => this.exports.colours(), "", new Uint8Array()).content);
  }

  /** Calls with a name and a content in the room of the module. */
  private call(action: (nameLength: number) => number, name: string, content: Uint8Array): Answer {
    try {
      const head = toBytes.encode(name);
      const length = head.length + content.length;
      const room = this.bytes(this.exports.room(length), length);
      room.set(head);
      room.set(content, head.length);
      const kind: Kind = action(head.length);
      return { kind, content: this.bytes(this.exports.answer(), this.exports.answer_length()).slice() };
    } catch (error) {
      throw new Failed(this.panic || (error instanceof Error ? error.message : String(error)));
    }
  }

  /** The memory of the module, which moves when it grows. Addresses come signed. */
  private bytes(address: number, length: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exports.memory.buffer as ArrayBuffer, address >>> 0, length >>> 0);
  }
}

/** Name, media type and content of a file that the module gives. */
export function parts(content: Uint8Array<ArrayBuffer>): { name: string; mediaType: string; content: Uint8Array<ArrayBuffer> } {
  const newline = 10;
  const first = content.indexOf(newline);
  const second = content.indexOf(newline, first + 1);
  return {
    name: toText.decode(content.subarray(0, first)),
    mediaType: toText.decode(content.subarray(first + 1, second)),
    content: content.subarray(second + 1),
  };
}
