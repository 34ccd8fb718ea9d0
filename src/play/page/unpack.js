// The solver out of its text: bytes in base 85, packed by LZMA. wasm/refresh.py says how.
(() => {
  const alphabet = '0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz'
    + '!#%()*+,-./:=?@^_{|}~$;';
  // How many of the last byte's bits tell what may come next.
  const literal_bits = 4;

  /// Four bytes of five characters.
  function bytes_of(digits) {
    const value = new Uint8Array(128);
    for (let k = 0; k < alphabet.length; k += 1) value[alphabet.charCodeAt(k)] = k;
    const bytes = new DataView(new ArrayBuffer(digits.length / 5 * 4));
    for (let k = 0; k < digits.length / 5; k += 1) {
      let number = 0;
      for (let i = 0; i < 5; i += 1) number = number * 85 + value[digits.charCodeAt(5 * k + i)];
      bytes.setUint32(4 * k, number);
    }
    return new Uint8Array(bytes.buffer);
  }

  /// Bits as likely as their model, a list of probabilities in 2048ths, has learned.
  class Bits {
    constructor(bytes) {
      Object.assign(this, { bytes, range: 2 ** 32 - 1, at: 5,
        code: new DataView(bytes.buffer).getUint32(1) });
    }

    next() {
      if (this.range >= 2 ** 24) return;
      this.range = this.range * 256;
      this.code = this.code * 256 + this.bytes[this.at];
      this.at += 1;
    }
    bit(model, k) {
      const bound = (this.range >>> 11) * model[k];
      const is_one = this.code >= bound;
      if (is_one) {
        this.range -= bound;
        this.code -= bound;
        model[k] -= model[k] >> 5;
      } else {
        this.range = bound;
        model[k] += (2048 - model[k]) >> 5;
      }
      this.next();
      return is_one ? 1 : 0;
    }
    /// A bit that may as well be the other.
    even() {
      this.range = Math.floor(this.range / 2);
      const bit = this.code >= this.range ? 1 : 0;
      this.code -= bit * this.range;
      this.next();
      return bit;
    }
    /// `count` bits, each with a model that knows those before it.
    tree(model, count) {
      let node = 1;
      for (let k = 0; k < count; k += 1) node = 2 * node + this.bit(model, node);
      return node - 2 ** count;
    }
    /// The same, lowest bit first.
    tree_upwards(model, count) {
      let [node, number] = [1, 0];
      for (let k = 0; k < count; k += 1) {
        const bit = this.bit(model, node);
        node = 2 * node + bit;
        number += bit * 2 ** k;
      }
      return number;
    }
  }

  const models = (size) => new Uint16Array(size).fill(1024);
  const many = (count, size) => [...Array(count)].map(() => models(size));

  /// How long what is repeated is.
  function length_reader(bits) {
    const [choice, short, middle, long] = [2, 8, 8, 256].map(models);
    return () => {
      if (!bits.bit(choice, 0)) return 2 + bits.tree(short, 3);
      return bits.bit(choice, 1) ? 18 + bits.tree(long, 8) : 10 + bits.tree(middle, 3);
    };
  }

  /// How far back what is repeated begins, minus one.
  function distance_reader(bits) {
    const [slots, near, low] = [many(4, 64), many(14, 64), models(16)];
    return (length) => {
      const slot = bits.tree(slots[Math.min(length - 2, 3)], 6);
      if (slot < 4) return slot;
      const count = (slot >> 1) - 1;
      const most = (2 + slot % 2) * 2 ** count;
      if (slot < 14) return most + bits.tree_upwards(near[slot], count);
      let middle = 0;
      for (let k = 4; k < count; k += 1) middle = 2 * middle + bits.even();
      return most + 16 * middle + bits.tree_upwards(low, 4);
    };
  }

  /// A byte that repeats none, after byte `last`; `instead`: the one that a repetition would bring,
  /// which it is not; -1 without one.
  function literal_reader(bits) {
    const literals = many(2 ** literal_bits, 768);
    return (last, instead) => {
      const model = literals[last >> (8 - literal_bits)];
      let [node, others] = [1, instead];
      while (node < 256) {
        if (others < 0) {
          node = 2 * node + bits.bit(model, node);
        } else {
          const other = (others >> 7) & 1;
          const bit = bits.bit(model, 256 * (1 + other) + node);
          node = 2 * node + bit;
          others = bit === other ? others * 2 : -1;
        }
      }
      return node - 256;
    };
  }

  function unpacked(bytes, size) {
    const bits = new Bits(bytes);
    const [length_of, again_length_of] = [length_reader(bits), length_reader(bits)];
    const [distance_of, literal_of] = [distance_reader(bits), literal_reader(bits)];
    const [is_match, is_again, not_last, not_second, not_third, is_long] =
      [...Array(6)].map(() => models(12));
    const out = new Uint8Array(size);
    let [at, state, last] = [0, 0, [0, 0, 0, 0]]; // the last four distances
    const again = () => {
      if (!bits.bit(not_last, state)) return bits.bit(is_long, state) ? 0 : -1;
      if (!bits.bit(not_second, state)) return 1;
      return bits.bit(not_third, state) ? 3 : 2;
    };
    while (at < size) {
      if (!bits.bit(is_match, state)) {
        out[at] = literal_of(at > 0 ? out[at - 1] : 0, state < 7 ? -1 : out[at - last[0] - 1]);
        at += 1;
        state = state < 4 ? 0 : state - (state < 10 ? 3 : 6);
        continue;
      }
      let length = 1;
      if (bits.bit(is_again, state)) {
        const which = again();
        if (which > 0) last = [last[which], ...last.filter((_, k) => k !== which)];
        if (which >= 0) length = again_length_of();
        state = (state < 7 ? 8 : 11) + (which < 0 && state < 7 ? 1 : 0);
      } else {
        length = length_of();
        last = [distance_of(length), ...last.slice(0, 3)];
        state = state < 7 ? 7 : 10;
      }
      for (const end = at + length; at < end; at += 1) out[at] = out[at - last[0] - 1];
    }
    return out;
  }

  /// The bytes of the module.
  play.unpack = (text) => {
    const [header, ...lines] = text.trim().split('\n');
    return unpacked(bytes_of(lines.join('')), Number(header.split(' ')[0]));
  };
})();
