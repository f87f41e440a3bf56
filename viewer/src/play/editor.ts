// SPDX-License-Identifier: MIT
/** The editor of a scenario: CodeMirror with what the schema proposes and what the loader says. It stands in a shadow tree, where it may
 * bring its own style sheet: the page allows no other. */
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap, startCompletion, type Completion, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory } from '@codemirror/commands';
import { yaml } from '@codemirror/lang-yaml';
import { bracketMatching, foldGutter, HighlightStyle, indentOnInput, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { highlightSelectionMatches, searchKeymap } from '@codemirror/search';
import { Annotation, EditorState, type Text } from '@codemirror/state';
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, hoverTooltip, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import type { Problem } from '../engine/questions.ts';
import { place_of, type Grammar } from './schema.ts';

export interface EditorOptions {
  grammar: Grammar;
  /** Names that only the texts know, for a key such as `tree`. */
  names(path: readonly string[]): string[];
  changed(file: string, text: string): void;
  fly(): void;
}

function completions({ grammar, names }: EditorOptions) {
  return (context: CompletionContext): CompletionResult | null => {
    const before = context.state.sliceDoc(0, context.pos);
    if (/(^|\s)#[^\n]*$/.test(before)) return null;
    const { path, at, said } = place_of(before);
    const word = /[^\s,:{}[\]]*$/.exec(before)![0];
    const from = context.pos - word.length;
    const quantity = /^[-+]?[\d.]+(?:e[-+]?\d+)?\s*(\S*)$/i.exec(said);
    const options: Completion[] = [];
    if (at === 'key') {
      for (const [key, { help, nested }] of grammar.keys(path)) options.push({ label: key, type: 'property', info: help, apply: nested ? `${key}:` : `${key}: ` });
      if (path.at(-1) === '-') for (const one of grammar.words(path)) options.push({ label: one, type: 'constant', info: grammar.keys(path).get(one)?.help ?? '' });
    } else if (quantity) {
      const unit_from = context.pos - quantity[1]!.length;
      const units = grammar.units(path).map((unit): Completion => ({ label: unit, type: 'unit', apply: /\s$/.test(before.slice(0, unit_from)) ? unit : ` ${unit}` }));
      return units.length ? { from: unit_from, options: units, validFor: /^[\w/²³]*$/ } : null;
    } else {
      for (const one of [...grammar.words(path), ...names(path)]) options.push({ label: one, type: 'constant' });
    }
    const starts = word !== '' || context.explicit || at === 'value' || /(^|\n)\s*(- )?$/.test(before) || /[{,]\s*$/.test(before);
    const wanted = context.explicit || word !== '' || (at === 'value' && said === '');
    return starts && wanted && options.length ? { from, options, validFor: /^[\w.-]*$/ } : null;
  };
}

/** What a key means, where the pointer rests on it. */
function meaning({ grammar }: EditorOptions) {
  return hoverTooltip((view, pos) => {
    const line = view.state.doc.lineAt(pos);
    const key = [...line.text.matchAll(/[\w-]+(?=\s*:(\s|$))|(?<=-\s+)[\w-]+/g)].find((one) => line.from + one.index <= pos && pos <= line.from + one.index + one[0].length);
    if (!key) return null;
    const end = line.from + key.index + key[0].length;
    const { path } = place_of(view.state.sliceDoc(0, end));
    const help = grammar.help([...path, key[0]]);
    if (!help) return null;
    return {
      pos: line.from + key.index, end, above: true,
      create: () => {
        const dom = document.createElement('div');
        dom.className = 'cm-meaning';
        dom.append(Object.assign(document.createElement('b'), { textContent: key[0] }), ` ${help}`);
        return { dom };
      },
    };
  });
}

/** The offset of a line and column from 1; a column is a character, of which some are two units of a string. */
export function offset(doc: Text, line: number, column: number): number {
  const { from, text } = doc.line(Math.min(Math.max(line, 1), doc.lines));
  return from + [...text].slice(0, Math.max(column, 1) - 1).join('').length;
}

function diagnostic(doc: Text, { line, column, message }: Problem): Diagnostic {
  const from = offset(doc, line, column);
  const rest = doc.sliceString(from, doc.lineAt(from).to);
  const length = /^("[^"]*"|'[^']*'|[^\s,:{}[\]#]+)/.exec(rest)?.[0].length ?? Math.min(1, rest.length);
  return { from, to: from + length, severity: 'error', message };
}

const kColors = HighlightStyle.define([
  { tag: [tags.definition(tags.propertyName), tags.propertyName], color: 'var(--blue)' },
  { tag: [tags.comment, tags.lineComment], color: 'var(--dim)', fontStyle: 'italic' },
  { tag: [tags.string, tags.special(tags.string)], color: 'var(--good)' },
  { tag: [tags.keyword, tags.typeName, tags.labelName], color: 'var(--red)' },
  { tag: [tags.punctuation, tags.separator, tags.brace, tags.squareBracket], color: 'var(--dim)' },
]);
const kTheme = EditorView.theme({
  '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--panel)', fontSize: '1.05rem' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: "ui-monospace, 'SF Mono', 'Cascadia Mono', Menlo, Consolas, 'DejaVu Sans Mono', monospace", lineHeight: '1.5' },
  '.cm-content': { caretColor: 'var(--accent)' },
  '.cm-cursor': { borderLeftColor: 'var(--accent)', borderLeftWidth: '2px' },
  '.cm-gutters': { color: 'var(--dim)', backgroundColor: 'var(--panel)', border: 'none' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--raised)' },
  '.cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground': { backgroundColor: 'var(--lit)' },
  '.cm-selectionMatch, .cm-matchingBracket, &.cm-focused .cm-matchingBracket': { backgroundColor: 'var(--hover)', outline: '1px solid var(--line)' },
  '.cm-tooltip, .cm-panels': { color: 'var(--ink)', backgroundColor: 'var(--panel)', border: '1px solid var(--line)', borderRadius: '0.3rem' },
  '.cm-tooltip': { boxShadow: '0 0.4rem 1.4rem var(--shade)' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul': { fontFamily: 'inherit', maxHeight: '16em' },
  '.cm-tooltip-autocomplete ul li[aria-selected]': { color: 'var(--ink)', backgroundColor: 'var(--lit)' },
  '.cm-completionMatchedText': { color: 'var(--accent)', textDecoration: 'none', fontWeight: '650' },
  '.cm-completionInfo, .cm-meaning, .cm-diagnostic': { maxWidth: '30rem', padding: '0.3rem 0.6rem', whiteSpace: 'pre-wrap', fontFamily: 'system-ui, sans-serif' },
  // what it comes with are images, which the page does not allow
  '.cm-lint-marker-error': { content: 'normal', width: '0.6em', height: '0.6em', margin: '0.35em 0.2em', borderRadius: '50%', backgroundColor: 'var(--red)' },
  '.cm-diagnostic-error': { borderLeftColor: 'var(--red)' },
  '.cm-lintRange-error': { backgroundImage: 'none', textDecoration: 'underline wavy var(--red)', textUnderlineOffset: '0.25em' },
  '.cm-textfield, .cm-button': { color: 'inherit', background: 'var(--raised)', border: '1px solid var(--line)' },
});

/** Of a change that shows what the project has already. */
const kShown = Annotation.define<true>();

export type Editor = ReturnType<typeof make_editor>;

export function make_editor(host: HTMLElement, options: EditorOptions) {
  const root = host.attachShadow({ mode: 'open' });
  let shown = '';
  const extensions = [
    lineNumbers(), lintGutter(), foldGutter(), history(), drawSelection(), indentOnInput(), bracketMatching(), closeBrackets(),
    highlightActiveLine(), highlightActiveLineGutter(), highlightSelectionMatches(), yaml(), syntaxHighlighting(kColors), kTheme,
    autocompletion({ override: [completions(options)], icons: false }), meaning(options), EditorState.tabSize.of(2),
    EditorView.contentAttributes.of({ tabindex: '0', 'aria-label': 'Scenario text', 'aria-description': 'Tab indents; Escape and then Tab leaves the text', spellcheck: 'false' }),
    keymap.of([
      { key: 'Mod-Enter', run: () => (options.fly(), true) }, ...closeBracketsKeymap, ...completionKeymap, ...searchKeymap, ...lintKeymap,
      ...historyKeymap, ...defaultKeymap, indentWithTab,
    ]),
    EditorView.updateListener.of(({ docChanged, state, transactions, view }) => {
      if (docChanged && !transactions.some((one) => one.annotation(kShown))) options.changed(shown, state.doc.toString());
      // a key that was chosen asks for its value
      if (transactions.some((one) => one.isUserEvent('input.complete')) && /: $/.test(state.sliceDoc(0, state.selection.main.head))) startCompletion(view);
    }),
  ];
  const view = new EditorView({ root, parent: root as unknown as Element });
  const states = new Map<string, EditorState>();
  return {
    /** Shows a file with its own history; a text that differs from what the editor has of it replaces that, which can be undone. */
    show(file: string, text: string): void {
      if (file !== shown) {
        if (shown) states.set(shown, view.state);
        shown = file;
        view.setState(states.get(file) ?? EditorState.create({ doc: text, extensions }));
      }
      const { doc } = view.state;
      if (doc.toString() === text) return;
      view.dispatch({ changes: { from: 0, to: doc.length, insert: text }, annotations: [kShown.of(true), isolateHistory.of('full')] });
    },
    /** Marks the mistakes of the file that is shown. */
    mark(problems: readonly Problem[]): void {
      const { state } = view;
      view.dispatch(setDiagnostics(state, problems.filter(({ line }) => line > 0).map((one) => diagnostic(state.doc, one))));
    },
    /** Puts the cursor there, from 1. */
    go_to(line: number, column: number): void {
      const anchor = offset(view.state.doc, line, column);
      view.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: 'center' }) });
      view.focus();
    },
  };
}
