// Addresses that carry a scene (#scene=.., or plainly #text=..) or a typed problem (#lcp=.., or
// plainly #problem=M|q, its spaces as %20; &step=3 opens it at that pivot, &guess asks first which
// row leaves), and files to keep.
(() => {
  const { by_id } = drawing.elements;

  const through = async (bytes, stream) => new Uint8Array(await new Response(
    new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

  async function packed(text) {
    const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
    return btoa(String.fromCharCode(...bytes)).replace(/\+/g, '-').replace(/\//g, '_')
      .replace(/=+$/, '');
  }
  async function unpacked(word) {
    const bytes = Uint8Array.from(atob(word.replace(/-/g, '+').replace(/_/g, '/')),
      (c) => c.charCodeAt(0));
    return new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw')));
  }

  /// {scene}, or {lcp, at}: what the address carries; {broken} if it cannot be read, {} if nothing.
  async function carried() {
    const [, kind, word, at] = /^#(text|scene|lcp|problem)=(.*?)((?:&step=\d+|&guess)*)$/
      .exec(location.hash) || [];
    const broken = 'The link is cut short or damaged: the page cannot show what it carried.';
    try {
      if (!kind) return {};
      if (kind === 'problem') return { lcp: decodeURIComponent(word).replace('|', '\n'), at };
      const text = kind === 'text' ? decodeURIComponent(word) : await unpacked(word);
      return text ? { [kind === 'lcp' ? 'lcp' : 'scene']: text, at } : { broken };
    } catch {
      return { broken };
    }
  }

  async function copy(kind, text, at = '') {
    const hash = `#${kind}=${await packed(text)}${at}`;
    try {
      history.replaceState(null, '', hash);
    } catch {
      // A page in a sandbox may not touch its address.
    }
    const address = location.href.replace(/#.*$/, '') + hash;
    try {
      await navigator.clipboard.writeText(address);
      return 'The link is copied.';
    } catch {
      return 'The link stands in the address bar.';
    }
  }

  function save(name, type, text) {
    const address = URL.createObjectURL(new Blob([text], { type }));
    const link = document.createElement('a');
    Object.assign(link, { href: address, download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  }

  /// The picture with the page's colours in it, as they are now.
  function picture() {
    const svg = document.querySelector('#picture svg').cloneNode(true);
    svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
    const style = document.createElementNS('http://www.w3.org/2000/svg', 'style');
    style.textContent = [...document.querySelectorAll('style')].map((one) => one.textContent).join('');
    svg.prepend(style);
    return new XMLSerializer().serializeToString(svg);
  }

  play.links = { carried, copy, save, picture, say: (words) => { by_id('done').textContent = words; } };
})();
