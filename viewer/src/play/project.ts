// SPDX-License-Identifier: MIT
/** What is edited: the shipped texts, what was changed in them, and which scenario flies with which seed. */

export type Files = Readonly<Record<string, string>>;

export interface Project {
  readonly shipped: Files;  // As they were shipped.
  edits: Files;  // What is other in them, by name.
  scenario: string;  // The name of the file that is flown.
  seed: string;  // Digits; "" for the scenario's own.
}

export const kFirst = 'scenarios/sweep.yaml';

export function text_of({ shipped, edits }: Project, file: string): string {
  return edits[file] ?? shipped[file] ?? '';
}
export function texts_of({ shipped, edits }: Project): Record<string, string> {
  return { ...shipped, ...edits };
}

/** With another text of a file; the shipped one is no edit. */
export function edited(project: Project, file: string, text: string): Project {
  const { [file]: _, ...others } = project.edits;
  return { ...project, edits: text === project.shipped[file] ? others : { ...others, [file]: text } };
}

/** Whether the engine takes it: a whole number below 2^64. */
export function is_seed(text: string): boolean {
  return /^\d{1,20}$/.test(text) && BigInt(text) < 2n ** 64n;
}

/** "scenarios/sweep.yaml" -> "sweep" */
export function name_of(file: string): string {
  return file.replace(/^.*\//, '').replace(/\.yaml$/, '');
}

export function scenarios(files: Files): string[] {
  return Object.keys(files).filter((file) => /^scenarios\/[^/]+\.yaml$/.test(file));
}

/** What the first lines of a scenario say of it: its `help`. */
export function help_of(text: string): string {
  return /^help:\s*(.*?)\s*$/m.exec(text)?.[1]?.replace(/^(["'])(.*)\1$/, '$2') ?? '';
}

/** A file with all that it extends and includes, itself first. */
export function with_includes(project: Project, file: string, known: string[] = []): string[] {
  known.push(file);
  const text = text_of(project, file);
  const folder = file.replace(/[^/]*$/, '');
  const [, base] = /^extends:[ \t]*([\w./-]+)/m.exec(text) ?? [];
  const said = /^include:((?:.|\n[ \t-])*)/m.exec(text)?.[1] ?? '';
  const names = [...said.replace(/#.*/g, '').matchAll(/[\w./-]+\.yaml/g)].map(([name]) => folder + name);
  if (base) names.unshift(/[./]/.test(base) ? folder + base : `scenarios/${base}.yaml`);
  for (const name of names) if (name in project.shipped && !known.includes(name)) with_includes(project, name, known);
  return known;
}

/** The seed that a scenario has of its own, or of what it extends. */
export function seed_of(project: Project): string {
  const seeds = with_includes(project, project.scenario).map((file) => /^seed:\s*(\d+)/m.exec(text_of(project, file))?.[1]);
  return seeds.find((seed) => seed !== undefined) ?? '1';
}

/** Whether something is edited that it flies with: itself, what it extends and includes, and the data that these and other data name. */
export function is_edited(project: Project): boolean {
  const used = with_includes(project, project.scenario);
  const others = new Set(Object.keys(project.shipped).filter((file) => file.startsWith('data/') && !used.includes(file)));
  for (const file of used) {  // grows meanwhile
    const words = new Set(text_of(project, file).match(/[\w-]+/g));
    for (const other of others) if (words.has(name_of(other)) && others.delete(other)) used.push(other);
  }
  return used.some((file) => file in project.edits);
}

/** The names of trees in the scenario and what it includes. */
export function tree_names(project: Project): string[] {
  const names = with_includes(project, project.scenario).flatMap((file) => {
    const trees = /^trees:[^\n]*\n((?:[ \t#].*\n|\n)*)/m.exec(`${text_of(project, file)}\n`)?.[1] ?? '';
    return [...trees.matchAll(/^ {2}([\w-]+):/gm)].map(([, name]) => name!);
  });
  return [...new Set(names)];
}
