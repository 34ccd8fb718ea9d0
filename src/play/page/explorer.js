// The pivots' own page, in a frame of this one.
(() => {
  const { by_id } = drawing.elements;

  /// The solver leaves the places open of what this page has already.
  const with_drawing = (page) => page.replace('/*LOOKS*/', () => by_id('looks').textContent)
    .replace('/*DRAWING*/', () => by_id('drawing').textContent);

  /// Shows the answer to a question of pivots; a sentence if there is none.
  async function explore(background, question, text) {
    try {
      const page = await background.ask(question.split(' ')[0], question, text);
      if (page === null) return '';
      by_id('frame').srcdoc = with_drawing(page);
      by_id('explorer')?.showModal();
      return '';
    } catch (refusal) {
      return refusal.message;
    }
  }

  play.explore = explore;
})();
