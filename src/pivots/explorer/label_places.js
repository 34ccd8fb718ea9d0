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

  const margin = 5;     // to the picture's edge
  const clearance = 3;  // to other words and to edges
  const barred = 1000;  // outweighs every way around
  const along_edge = 8; // a pixel of a leader that cannot be told from an edge

  const overlap = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0]))
    * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));

  /// The place of a label that is next to `target`.
  const leader_end = (rect, [x, y]) =>
    [Math.max(rect[0], Math.min(x, rect[2])), Math.max(rect[1], Math.min(y, rect[3]))];

  /// How many pixels of a line lie in a rectangle, in steps of 4.
  function length_inside(rect, [x0, y0], [x1, y1]) {
    if (Math.max(x0, x1) < rect[0] || Math.min(x0, x1) > rect[2]
      || Math.max(y0, y1) < rect[1] || Math.min(y0, y1) > rect[3]) return 0;
    const pieces = Math.max(1, Math.floor(Math.hypot(x1 - x0, y1 - y0) / 4));
    let inside = 0;
    for (let k = 0; k <= pieces; ++k) {
      const [x, y] = [x0 + (x1 - x0) * k / pieces, y0 + (y1 - y0) * k / pieces];
      if (x > rect[0] && x < rect[2] && y > rect[1] && y < rect[3]) inside += 4;
    }
    return inside;
  }

  class Places {
    constructor(width, height) {
      this.width = width;
      this.height = height;
      this.taken = []; // [left, top, right, bottom, weight]
      this.words = []; // of the labels placed
      this.edges = []; // those barred, piece by piece
      this.cost = 0;   // of the labels placed
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
      this.block(left - clearance, top - clearance, right + clearance, bottom + clearance, barred);
    }

    bar_edges(corners) {
      const first = this.taken.length;
      corners.forEach((corner, k) =>
        this.block_line(corner, corners[(k + 1) % corners.length], barred));
      this.edges.push(...this.taken.slice(first));
    }

    /// What a label there costs, `begin` included; once that is `most`, no more is added up.
    cost_of(rect, target, begin, most) {
      let cost = begin;
      for (const other of this.taken) {
        const area = overlap(rect, other);
        if (area > 0) cost += (area + 20) * other[4];
        if (cost >= most) return cost;
      }
      const end = leader_end(rect, target);
      for (const word of this.words) cost += barred * length_inside(word, end, target);
      for (const edge of this.edges) cost += along_edge * length_inside(edge, end, target);
      return cost;
    }

    /// Where lines of text near (x, y) cover least: {left, top, width, height, leader}. `away` is
    /// the side on which they should lie, a direction; (0, 0) for any. `target` is what they name,
    /// where their leader begins.
    place(lines, [x, y], away, target) {
      const width = Math.max(...lines.map(width_of)) + 6;
      const height = lines.length * line + 2;
      let best = null;
      for (let radius = 12; radius <= 172; radius += 10) {
        for (let k = 0; k < 24; ++k) {
          const angle = 2 * Math.PI * (k + 0.5) / 24;
          const [cx, cy] = [x + Math.cos(angle) * (radius + width / 2),
            y + Math.sin(angle) * (radius + height / 2)];
          const rect = [cx - width / 2, cy - height / 2, cx + width / 2, cy + height / 2];
          if (rect[0] < margin || rect[1] < margin || rect[2] > this.width - margin
            || rect[3] > this.height - margin) continue;
          const side = away[0] * (cx - x) + away[1] * (cy - y);
          const near = radius * 1.2 + Math.abs(Math.sin(angle)) * 4
            + Math.max(0, -side - 40) * 12;
          const most = best ? best.cost : Infinity;
          if (near >= most) continue;
          const cost = this.cost_of(rect, target, near, most);
          if (cost < most) best = { cost, rect };
        }
      }
      const rect = best ? best.rect : [2, 2, 2 + width, 2 + height];
      this.cost += best ? best.cost : 1e9;
      const leader = leader_end(rect, target);
      this.bar(...rect);
      this.words.push(rect);
      this.block_line(leader, target, 20);
      return { left: rect[0], top: rect[1], width, height, line, leader };
    }
  }

  /// The places of labels {words, at, away, target}, in the order that gives them the best ones, of
  /// those that let each be the first.
  function place_all(places, labels) {
    let best = null;
    const taken = [...places.taken].sort((a, b) => b[4] - a[4]); // the dearest decide soonest
    for (let first = 0; first < labels.length; ++first) {
      const tried = Object.assign(new Places(places.width, places.height),
        { taken: [...taken], edges: places.edges });
      const boxes = [];
      for (let k = 0; k < labels.length; ++k) {
        const which = (first + k) % labels.length;
        const { words, at, away, target } = labels[which];
        boxes[which] = tried.place(words, at, away || [0, 0], target);
      }
      if (best === null || tried.cost < best.cost) best = { cost: tried.cost, boxes };
    }
    return best ? best.boxes : [];
  }

  explorer.Places = Places;
  explorer.place_all = place_all;
})();
