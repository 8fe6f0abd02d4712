// Turns places in the scene into places on the stage, for the whole picture or a part of it that the
// reader has chosen.

class View {
  constructor() {
    this.own = null;  // {zoom, left, top} once the reader has chosen a part
    this.fitted = { zoom: 1, left: 0, top: 0 };
    this.size = null;  // of the stage
  }

  get now() {
    return this.own ?? this.fitted;
  }

  /** Lets a box fill the stage, with a margin, as long as the reader has chosen nothing else. */
  fit(box, width, height, margin) {
    this.keepMiddle(width, height);
    // A window that is being opened or changed may have no room between the margins for a moment.
    const room = [width, height].map((side) => Math.max(side - 2 * margin, 1));
    const most = Math.min(room[0] / (box[2] - box[0]), room[1] / (box[3] - box[1]));
    const zoom = Number.isFinite(most) ? most : 1;
    this.fitted = {
      zoom,
      left: width / 2 - zoom * (box[0] + box[2]) / 2,
      top: height / 2 + zoom * (box[1] + box[3]) / 2,
    };
  }

  /** Keeps what is in the middle of the stage there when the stage gets another size. */
  keepMiddle(width, height) {
    const [oldWidth, oldHeight] = this.size ?? [width, height];
    this.size = [width, height];
    if (this.own === null || (width === oldWidth && height === oldHeight) || !(width * height > 0)) {
      return;
    }
    const scale = Math.min(width / oldWidth, height / oldHeight);
    const { zoom, left, top } = this.own;
    this.own = {
      zoom: scale * zoom,
      left: width / 2 + scale * (left - oldWidth / 2),
      top: height / 2 + scale * (top - oldHeight / 2),
    };
  }

  /** Keeps the present part, whatever the mechanism does. */
  hold() {
    this.own = this.now;
  }

  showAll() {
    this.own = null;
  }

  pan(right, down) {
    const { zoom, left, top } = this.now;
    this.own = { zoom, left: left + right, top: top + down };
  }

  /** Enlarges the picture by a factor about a place on the stage. */
  enlarge(factor, [x, y]) {
    const { zoom, left, top } = this.now;
    const most = 1e4 * this.fitted.zoom;
    const least = 1e-2 * this.fitted.zoom;
    const next = Math.min(Math.max(zoom * factor, least), most);
    const scale = next / zoom;
    this.own = { zoom: next, left: x + scale * (left - x), top: y + scale * (top - y) };
  }

  at(x, y) {
    const { zoom, left, top } = this.now;
    return [left + zoom * x, top - zoom * y];
  }

  /** The place in the scene under a place on the stage. */
  under([x, y]) {
    const { zoom, left, top } = this.now;
    return [(x - left) / zoom, (top - y) / zoom];
  }
}
