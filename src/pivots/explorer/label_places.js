// Places labels one after the other where they cover nothing placed before.
(() => {
  const line = 14.5;
  let context = null;

  /// The width of a text as the page will draw it (explorer.css, .view .label).
  function width_of(text) {
    if (!context) {
      context = document.createElement('canvas').getContext('2d');
      const family = getComputedStyle(document.documentElement).getPropertyValue('--sans');
      context.font = `600 12.5px ${family}`;
    }
    return context.measureText(text).width;
  }

  const margin = 5; // to the picture's edge
  const barred = 1000; // outweighs every way around

  const overlap = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0]))
    * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));

  class Places {
    constructor(width, height) {
      this.width = width;
      this.height = height;
      this.taken = []; // [left, top, right, bottom, weight]
    }

    /// Something drawn that labels should stay clear of, the more the heavier.
    block(left, top, right, bottom, weight) {
      this.taken.push([Math.min(left, right), Math.min(top, bottom), Math.max(left, right),
        Math.max(top, bottom), weight]);
    }

    block_line([x0, y0], [x1, y1], weight) {
      const pieces = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / 8));
      for (let k = 0; k < pieces; ++k) {
        const at = (t) => [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t];
        const [a, b] = [at(k / pieces), at((k + 1) / pieces)];
        this.block(Math.min(a[0], b[0]) - 2, Math.min(a[1], b[1]) - 2, Math.max(a[0], b[0]) + 2,
          Math.max(a[1], b[1]) + 2, weight);
      }
    }

    /// What labels must not touch while there is any other place: edges, words.
    bar(left, top, right, bottom) {
      this.block(left - 3, top - 3, right + 3, bottom + 3, barred);
    }

    bar_edges(corners) {
      corners.forEach((corner, k) =>
        this.block_line(corner, corners[(k + 1) % corners.length], barred));
    }

    /// Where lines of text near (x, y) cover least: {left, top, width, height, line, leader}. `away`
    /// is the side on which they should lie, a direction; (0, 0) for any. `target` is what they
    /// name, where their leader begins.
    place(lines, [x, y], away, target) {
      const width = Math.max(...lines.map(width_of)) + 6;
      const height = lines.length * line + 2;
      let [least, best] = [Infinity, [2, 2, 2 + width, 2 + height]];
      for (let radius = 12; radius <= 172; radius += 10) {
        for (let k = 0; k < 24; ++k) {
          const angle = 2 * Math.PI * (k + 0.5) / 24;
          const [cx, cy] = [x + Math.cos(angle) * (radius + width / 2),
            y + Math.sin(angle) * (radius + height / 2)];
          const rect = [cx - width / 2, cy - height / 2, cx + width / 2, cy + height / 2];
          if (rect[0] < margin || rect[1] < margin || rect[2] > this.width - margin
            || rect[3] > this.height - margin) continue;
          const side = away[0] * (cx - x) + away[1] * (cy - y);
          const cost = this.taken.reduce((sum, other) => {
            const area = overlap(rect, other);
            return area > 0 ? sum + (area + 20) * other[4] : sum;
          }, radius * 1.2 + Math.abs(Math.sin(angle)) * 4 + Math.max(0, -side - 40) * 12);
          if (cost < least) [least, best] = [cost, rect];
        }
      }
      const leader = [Math.max(best[0], Math.min(target[0], best[2])),
        Math.max(best[1], Math.min(target[1], best[3]))];
      this.bar(...best);
      this.block_line(leader, target, 20);
      return { left: best[0], top: best[1], width, height, line, leader };
    }
  }

  explorer.Places = Places;
})();
