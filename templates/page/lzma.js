// Turns bytes that were packed as LZMA into the original bytes, which no browser does by itself.
"use strict";

/** The content of a file of the format `.lzma` that has an end marker. */
function unpacked(packed) {
  const [contextBits, placeBits, positionBits] =
    [packed[0] % 9, Math.floor(packed[0] / 9) % 5, Math.floor(packed[0] / 45)];
  const chances = (count) => new Uint16Array(count).fill(1024);
  let out = new Uint8Array(1 << 20);
  let size = 0;
  let next = 14;  // after the header, and a byte that is always zero
  let range = 0xFFFFFFFF;
  let code = 0;
  for (let byte = 0; byte < 4; ++byte) {
    code = (code << 8 | packed[next++]) >>> 0;
  }

  const refill = () => {
    if (range < 0x1000000) {
      range = (range << 8) >>> 0;
      code = (code << 8 | packed[next++]) >>> 0;
    }
  };
  /** A bit, decoded by its probability of being zero, which is then adapted to the bit. */
  const bit = (known, at) => {
    const bound = (range >>> 11) * known[at];
    const isOne = code >= bound;
    if (isOne) {
      range -= bound;
      code -= bound;
      known[at] -= known[at] >> 5;
    } else {
      range = bound;
      known[at] += (2048 - known[at]) >> 5;
    }
    refill();
    return isOne ? 1 : 0;
  };
  const evenBits = (count) => {
    let value = 0;
    for (let done = 0; done < count; ++done) {
      range >>>= 1;
      const isOne = code >= range;
      code -= isOne ? range : 0;
      value = 2 * value + (isOne ? 1 : 0);
      refill();
    }
    return value;
  };
  /** Some bits, the highest first. */
  const number = (known, at, count) => {
    let node = 1;
    for (let done = 0; done < count; ++done) {
      node = node << 1 | bit(known, at + node);
    }
    return node - (1 << count);
  };
  /** Some bits, the lowest first. */
  const backwards = (known, at, count) => {
    let node = 1;
    let value = 0;
    for (let done = 0; done < count; ++done) {
      const one = bit(known, at + node);
      node = node << 1 | one;
      value |= one << done;
    }
    return value;
  };

  const lengths = () => ({ choice: chances(2), low: chances(128), middle: chances(128), high: chances(256) });
  const lengthOf = (known, position) => {
    if (bit(known.choice, 0) === 0) {
      return 2 + number(known.low, 8 * position, 3);
    }
    return bit(known.choice, 1) === 0
      ? 10 + number(known.middle, 8 * position, 3) : 18 + number(known.high, 0, 8);
  };
  const slots = chances(4 * 64);
  const nearDistances = chances(115);
  const lowBits = chances(16);
  const distanceOf = (length) => {
    const slot = number(slots, 64 * Math.min(length - 2, 3), 6);
    if (slot < 4) {
      return slot;
    }
    const bits = (slot >> 1) - 1;
    const least = (2 | slot & 1) * 2 ** bits;
    return slot < 14 ? least + backwards(nearDistances, least - slot, bits)
      : least + 16 * evenBits(bits - 4) + backwards(lowBits, 0, 4);
  };

  const put = (byte) => {
    if (size === out.length) {
      const larger = new Uint8Array(2 * size);
      larger.set(out);
      out = larger;
    }
    out[size++] = byte;
  };
  const literals = chances(0x300 << (contextBits + placeBits));
  /** A literal byte; after a copy it differs from `differs`, the byte that would have come next. */
  const literal = (differs) => {
    const before = size > 0 ? out[size - 1] : 0;
    const at = 0x300 * (((size & (1 << placeBits) - 1) << contextBits) + (before >> (8 - contextBits)));
    let symbol = 1;
    for (let shift = 7; differs >= 0 && symbol < 0x100; --shift) {
      const expected = differs >> shift & 1;
      const found = bit(literals, at + ((1 + expected) << 8) + symbol);
      symbol = symbol << 1 | found;
      if (found !== expected) {
        break;
      }
    }
    while (symbol < 0x100) {
      symbol = symbol << 1 | bit(literals, at + symbol);
    }
    return symbol & 0xFF;
  };

  const [isCopy, isLong] = [chances(192), chances(192)];
  const [isRepeated, isOlder, isThird, isFourth] = [0, 1, 2, 3].map(() => chances(12));
  const [fresh, repeated] = [lengths(), lengths()];
  let state = 0;
  let last = [0, 0, 0, 0];  // the distances of the last four copies, each less one
  /** Moves the distance that is used again to the front. */
  const again = () => {
    const used = bit(isThird, state) === 0 ? 1 : bit(isFourth, state) === 0 ? 2 : 3;
    last = [last[used], ...last.filter((_, place) => place !== used)];
  };
  while (true) {
    const position = size & (1 << positionBits) - 1;
    if (bit(isCopy, 16 * state + position) === 0) {
      put(literal(state >= 7 ? out[size - last[0] - 1] : -1));
      state = state < 4 ? 0 : state - (state < 10 ? 3 : 6);
      continue;
    }
    let length = 1;
    if (bit(isRepeated, state) === 0) {
      length = lengthOf(fresh, position);
      last = [distanceOf(length), last[0], last[1], last[2]];
      state = state < 7 ? 7 : 10;
      if (last[0] === 0xFFFFFFFF) {
        return out.subarray(0, size);
      }
    } else {
      const isOld = bit(isOlder, state) === 1;
      if (isOld) {
        again();
      }
      if (isOld || bit(isLong, 16 * state + position) === 1) {
        length = lengthOf(repeated, position);
        state = state < 7 ? 8 : 11;
      } else {
        state = state < 7 ? 9 : 11;
      }
    }
    for (let done = 0; done < length; ++done) {
      put(out[size - last[0] - 1]);
    }
  }
}
