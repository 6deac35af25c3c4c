// What a worker has from the scripts that it imports.
declare const runCommand: RunCommand;
declare const clearcutModule: MakeModule;
