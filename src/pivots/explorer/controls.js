// Buttons, slider, keys and the address: all ways to choose a step.
(() => {
  const { by_id } = drawing.elements;
  const pauses = { slow: 2400, medium: 1200, fast: 350 };

  function create(app) {
    let timer = null;

    function show_playing() {
      const playing = timer !== null;
      by_id('play').setAttribute('aria-pressed', String(playing));
      by_id('play').setAttribute('aria-label', playing ? 'Pause' : 'Play');
      by_id('play').classList.toggle('playing', playing);
    }

    const stop = () => {
      if (timer !== null) clearInterval(timer);
      timer = null;
      show_playing();
    };

    const play = () => {
      if (app.frame >= app.path.last) app.go(0);
      timer = setInterval(() => {
        if (app.frame >= app.path.last) stop();
        else app.go(app.frame + 1);
      }, pauses[by_id('speed').value]);
      show_playing();
    };

    const toggle = () => (timer === null ? play() : stop());
    const choose = (frame) => { stop(); app.go(frame); };

    by_id('first').addEventListener('click', () => choose(0));
    by_id('back').addEventListener('click', () => choose(app.frame - 1));
    by_id('forward').addEventListener('click', () => choose(app.frame + 1));
    by_id('last').addEventListener('click', () => choose(app.path.last));
    by_id('play').addEventListener('click', toggle);
    by_id('speed').addEventListener('change', () => { if (timer !== null) { stop(); play(); } });
    by_id('slider').addEventListener('input', (event) => choose(Number(event.target.value)));
    by_id('jump').addEventListener('change', (event) => {
      const frame = app.path.frames.findIndex(({ pivot }) => pivot === Number(event.target.value));
      choose(frame < 0 ? app.path.last : frame);
    });
    by_id('return').addEventListener('click', () => { stop(); app.return_to_recorded(); });

    document.addEventListener('keydown', (event) => {
      if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
      const { target } = event;
      if (target.closest('input, select, textarea, [contenteditable]')) return;
      // Space and the arrows keep their own meaning on a button and in a box that scrolls.
      const own = target.closest('button, summary, a');
      const scrolls = target.closest('[tabindex]');
      const row = /^[1-9]$/.test(event.key) && Number(event.key) - 1;
      const actions = {
        g: () => app.guess_first(!app.guesses.on), l: () => app.toggle_room(),
        ArrowRight: () => choose(app.frame + 1), ArrowLeft: () => choose(app.frame - 1),
        Home: () => choose(0), End: () => choose(app.path.last), ' ': toggle,
      };
      const action = row !== false ? () => app.tableau.try_row(row) : actions[event.key];
      if (!action || (scrolls && event.key.length > 1) || (own && event.key === ' ')) return;
      event.preventDefault();
      action();
    });

    window.addEventListener('hashchange', () => app.read_address());

    function update() {
      const { last } = app.path;
      const slider = by_id('slider');
      slider.max = last;
      slider.value = app.frame;
      slider.setAttribute('aria-valuetext', app.path.where(app.frame));
      const pivots = app.path.pivots.length;
      by_id('jump').max = pivots;
      by_id('jump').value = app.path.frames[app.frame].done;
      by_id('count').textContent = `of 0..${Math.max(0, pivots - 1)}`;
      for (const id of ['first', 'back']) by_id(id).disabled = app.frame === 0;
      for (const id of ['forward', 'last']) by_id(id).disabled = app.frame === last;
    }
    return { update, stop };
  }

  explorer.controls = { create };
})();
