// SPDX-License-Identifier: MIT
/** Opens the playground with the texts that stand in the page. */
import { render } from 'preact';
import { engine_module, painted, parts } from '../parts.ts';
import { unpacked } from '../packed.ts';
import { put_theme, say_failure } from '../show.tsx';
import { first_view } from '../store.ts';
import { remembered } from '../ui/link.ts';
import { Playground, type Opened } from './playground.tsx';

async function open(host: HTMLElement): Promise<void> {
  const view = { ...first_view(0), ...remembered() };
  put_theme(view.theme);
  const [texts] = parts('texts');
  if (!texts) throw new Error('there are no texts in this page; ./eyrie playground writes one with them');
  await painted();
  const [module, bytes] = await Promise.all([engine_module(), unpacked(texts)]);
  const { files, schema } = JSON.parse(new TextDecoder().decode(bytes)) as Pick<Opened, 'files' | 'schema'>;
  host.replaceChildren();
  render(<Playground files={files} schema={schema} module={module} host={host} view={view} />, host);
  document.body.dataset['open'] = 'true';
}

const host = document.getElementById('app')!;
open(host).catch((error: unknown) => say_failure(host, 'The playground cannot be opened', error));
