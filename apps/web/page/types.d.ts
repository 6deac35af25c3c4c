// Types of the page without a server and of its workers, for the checker (`make lint-viewer`); no page holds this file.

/** A file's name and what it holds. */
type NamedBytes = [string, Uint8Array];

/** How a run of the command ended: exit code, standard output, and the files of its folder results/ by their names. */
interface CommandEnd { code: number; text: string; results: Record<string, Uint8Array<ArrayBuffer>> }

/** What the page tells a worker to do: the compiled command, words as on the command line, and the files it finds where it runs. */
interface WorkerTask { wasm: WebAssembly.Module; words: string[]; files: NamedBytes[] }
/** What a worker tells the page: a line of the command's messages, at last how it ended, or why it could not. */
type WorkerMessage = { line: string } | { end: CommandEnd } | { broken: string };

/** What the page uses of the module that emscripten's script makes. */
interface CommandModule {
  FS: {
    mkdir(path: string): void; chdir(path: string): void; readdir(path: string): string[];
    writeFile(path: string, bytes: Uint8Array): void; readFile(path: string): Uint8Array<ArrayBuffer>;
  };
  /** Variables of the command's environment. */
  ENV: Record<string, string>;
  /** Runs the command; gives its exit code. */
  callMain(words: string[]): number;
}
/** What it takes to make one. */
interface CommandModuleSettings {
  noInitialRun: boolean;
  quit(status: number, thrown: unknown): void;
  print(line: string): void;
  printErr(line: string): void;
  instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance, wasm: WebAssembly.Module) => void): object;
  preRun: ((module: CommandModule) => void)[];
}
type MakeModule = (settings: CommandModuleSettings) => Promise<CommandModule>;
type RunCommand = (makeModule: MakeModule, wasm: WebAssembly.Module, words: string[], files: NamedBytes[], heard: (line: string) => void) => Promise<CommandEnd>;
