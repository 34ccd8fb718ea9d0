// Undo and redo: scenes as texts.
(() => {
  class History {
    constructor(text) { Object.assign(this, { done: [text], undone: [] }); }

    push(text) {
      if (text === this.done.at(-1)) return;
      this.done.push(text);
      this.undone = [];
    }
    undo() {
      if (this.done.length > 1) this.undone.push(this.done.pop());
      return this.done.at(-1);
    }
    redo() {
      if (this.undone.length > 0) this.done.push(this.undone.pop());
      return this.done.at(-1);
    }
  }

  play.History = History;
})();
