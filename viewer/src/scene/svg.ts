// SPDX-License-Identifier: MIT
/** As much of a 2-D canvas as the flat picture is drawn with, written as SVG instead. */

const n = (value: number): string => String(Number(value.toFixed(2)));

/** Stands for Path2D, too. */
class SvgPath {
  d = '';
  moveTo(x: number, y: number): void {
    this.d += `M${n(x)} ${n(y)}`;
  }
  lineTo(x: number, y: number): void {
    this.d += `${this.d ? 'L' : 'M'}${n(x)} ${n(y)}`;
  }
  closePath(): void {
    this.d += 'Z';
  }
  /** Only whole ones are drawn. */
  ellipse(x: number, y: number, rx: number, ry: number): void {
    this.d += `M${n(x - rx)} ${n(y)}a${n(rx)} ${n(ry)} 0 1 0 ${n(2 * rx)} 0a${n(rx)} ${n(ry)} 0 1 0 ${n(-2 * rx)} 0Z`;
  }
  arc(x: number, y: number, r: number): void {
    this.ellipse(x, y, r, r);
  }
  rect(x: number, y: number, w: number, h: number): void {
    this.d += `M${n(x)} ${n(y)}h${n(w)}v${n(h)}h${n(-w)}Z`;
  }
  roundRect(x: number, y: number, w: number, h: number, wanted: number): void {
    const r = Math.min(wanted, w / 2, h / 2);
    const corner = (dx: number, dy: number): string => `a${n(r)} ${n(r)} 0 0 1 ${n(dx)} ${n(dy)}`;
    this.d += `M${n(x + r)} ${n(y)}h${n(w - 2 * r)}${corner(r, r)}v${n(h - 2 * r)}${corner(-r, r)}h${n(2 * r - w)}${corner(-r, -r)}v${n(2 * r - h)}${corner(r, -r)}Z`;
  }
}

interface Gradient { id: string; addColorStop(at: number, color: string): void }

export class SvgPen extends SvgPath {
  fillStyle: string | Gradient = '#000';
  strokeStyle = '#000';
  lineWidth = 1;
  lineJoin = 'miter';
  globalAlpha = 1;
  font = '';
  textAlign = 'left';
  textBaseline = 'middle';
  private dash: number[] = [];
  private readonly parts: string[] = [];
  private readonly gradients = new Map<string, { head: string; stops: string }>();

  setTransform(): void {}
  clearRect(): void {}
  beginPath(): void {
    this.d = '';
  }
  setLineDash(dash: number[]): void {
    this.dash = dash;
  }
  createRadialGradient(x0: number, y0: number, r0: number, x: number, y: number, r: number): Gradient {
    const id = `g${this.gradients.size}`;
    const gradient = { head: `cx="${n(x)}" cy="${n(y)}" r="${n(r)}" fx="${n(x0)}" fy="${n(y0)}" fr="${n(r0)}"`, stops: '' };
    this.gradients.set(id, gradient);
    return { id, addColorStop: (at, color) => (gradient.stops += `<stop offset="${at}" stop-color="${color}"/>`) };
  }
  private put(element: string): void {
    this.parts.push(this.globalAlpha < 1 ? `<g opacity="${n(this.globalAlpha)}">${element}</g>` : element);
  }
  private paint(): string {
    return typeof this.fillStyle === 'string' ? this.fillStyle : `url(#${this.fillStyle.id})`;
  }
  fill(path: SvgPath = this, rule = ''): void {
    if (path.d) this.put(`<path d="${path.d}" fill="${this.paint()}"${rule ? ` fill-rule="${rule}"` : ''}/>`);
  }
  stroke(path: SvgPath = this): void {
    const dash = this.dash.length ? ` stroke-dasharray="${this.dash.map(n).join(' ')}"` : '';
    if (path.d) this.put(`<path d="${path.d}" fill="none" stroke="${this.strokeStyle}" stroke-width="${n(this.lineWidth)}" stroke-linejoin="${this.lineJoin}"${dash}/>`);
  }
  fillRect(x: number, y: number, w: number, h: number): void {
    this.put(`<rect x="${n(x)}" y="${n(y)}" width="${n(w)}" height="${n(h)}" fill="${this.paint()}"/>`);
  }
  fillText(text: string, x: number, y: number): void {
    const words = text.replace(/&/g, '&amp;').replace(/</g, '&lt;');
    const [size = '', ...family] = this.font.split(' ');
    const anchor = { center: 'middle', right: 'end' }[this.textAlign] ?? 'start';
    this.put(`<text x="${n(x)}" y="${n(y)}" font-size="${size}" font-family='${family.join(' ')}' text-anchor="${anchor}" dominant-baseline="central" fill="${this.paint()}" xml:space="preserve">${words}</text>`);
  }
  drawImage(image: HTMLCanvasElement, x: number, y: number, w: number, h: number): void {
    this.put(`<image x="${n(x)}" y="${n(y)}" width="${n(w)}" height="${n(h)}" href="${image.toDataURL()}"/>`);
  }

  /** What another one has drawn, above this. */
  append(other: SvgPen): void {
    this.parts.push(...other.parts);
  }

  text(width: number, height: number): string {
    const defs = [...this.gradients].map(([id, { head, stops }]) => `<radialGradient id="${id}" gradientUnits="userSpaceOnUse" ${head}>${stops}</radialGradient>`);
    return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${n(width)} ${n(height)}" width="${n(width)}" height="${n(height)}"><defs>${defs.join('')}</defs>${this.parts.join('\n')}</svg>\n`;
  }
}

/** Whoever makes paths while `draw` runs makes these. */
export function with_svg_paths(draw: () => void): void {
  const real = globalThis.Path2D;
  globalThis.Path2D = SvgPath as unknown as typeof Path2D;
  try {
    draw();
  } finally {
    globalThis.Path2D = real;
  }
}
