// A page of pictures of balls, a row for each way to make them and a column for each ball, and of models.

/// The displayed value of linear light, by sRGB.
export const displayed = (light) => {
  const most = Math.min(Math.max(light, 0), 1);
  return Math.round(255 * (most <= 0.0031308 ? 12.92 * most : 1.055 * most ** (1 / 2.4) - 0.055));
};

/// A picture of linear light, from the lowest row, as a .bmp in a link. Its width is a multiple of four.
function linkOf(picture, width_px, height_px, exposure) {
  const header = Buffer.alloc(54);
  header.write('BM');
  header.writeUInt32LE(54 + 3 * width_px * height_px, 2);
  header.writeUInt32LE(54, 10);
  header.writeUInt32LE(40, 14);
  header.writeInt32LE(width_px, 18);
  header.writeInt32LE(height_px, 22);
  header.writeUInt16LE(1, 26);
  header.writeUInt16LE(24, 28);
  const blueFirst = picture.map((_, i) => displayed(exposure * picture[3 * Math.floor(i / 3) + 2 - (i % 3)]));
  return `data:image/bmp;base64,${Buffer.concat([header, Buffer.from(blueFirst)]).toString('base64')}`;
}

function sheetOf({ name, balls, rows }, side) {
  const [truth] = rows;
  const light = truth.pictures.at(-1);
  const exposure = (0.3 * light.length) / light.reduce((sum, value) => sum + value, 0);
  const heads = balls.map(({ material, roughness }) => `<th>${material} ${roughness}</th>`).join('');
  const lines = rows.map((row) => {
    const cells = row.pictures.map((picture, i) => {
      const errors = row.errors?.[i];
      const caption = errors ? `${errors.rms.toFixed(1)} % (${errors.mean.toFixed(1)} %)` : '';
      return `<td><img src="${linkOf(picture, side, side, exposure)}"><br>${caption}</td>`;
    });
    return `<tr><th>${row.name}</th>${cells.join('')}</tr>`;
  });
  return `<h1>${name}</h1>\n<table><tr><th></th>${heads}</tr>\n${lines.join('\n')}\n</table>\n`;
}

/// rows   a picture each, and how far it is from the first
const modelOf = ({ name, rows, width_px, height_px, exposure }) => {
  const figures = rows.map(({ name: way, picture, psnr_dB }) =>
    `<figure><img src="${linkOf(picture, width_px, height_px, exposure)}"><figcaption>${way}
${psnr_dB ? `${psnr_dB.toFixed(1)} dB` : ''}</figcaption></figure>`);
  return `<h1>${name}</h1>\n${figures.join('\n')}\n`;
};

/// sheets   of an environment each: its name, the balls, and rows whose first is the truth
/// models   of a model in an environment each
export function pageOf(sheets, side, models) {
  return `<!doctype html>
<meta charset="utf-8">
<title>Web engines, with their own filters and with our files</title>
<style>
body { font: 12px sans-serif }
td { text-align: center; white-space: nowrap; vertical-align: top }
th { text-align: left; max-width: 9em }
figure { display: inline-block; margin: 4px }
</style>
<p>RMS error, and in brackets the error of the mean, as shares of the mean light.</p>
${sheets.map((sheet) => sheetOf(sheet, side)).join('')}${models.map(modelOf).join('')}`;
}
