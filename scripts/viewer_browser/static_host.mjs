// A host of a folder as any static host is, on this machine alone, under /app/. What it was asked is kept.
import {createReadStream, existsSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join} from 'node:path';

/** @type {Record<string, string>} */
const KINDS = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json'
};

/** @type {(site: string) => Promise<{ host: import('node:http').Server, address: string, asked: string[] }>} */
export async function hostOf(site) {
  /** @type {string[]} */
  const asked = [];
  const host = createServer((request, response) => {
    const name = new URL(request.url ?? '', 'http://host').pathname.replace(/^\/app\//, '') || 'index.html', file = join(site, name);
    asked.push(`${request.method} ${name}`);
    if (!/^[\w.]+$/.test(name) || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, {'Content-Type': KINDS[extname(name)] ?? 'application/octet-stream'});
    return createReadStream(file).pipe(response);
  });
  await new Promise(ready => {
    host.listen(0, '127.0.0.1', () => ready(true));
  });
  const bound = host.address();
  return {host, address: `http://127.0.0.1:${bound !== null && typeof bound === 'object' ? bound.port : 0}/app/`, asked};
}
