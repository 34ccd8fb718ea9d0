// The explorer's one global name. The files of scripts.txt are joined in that order behind those of
// src/draw/script; each adds its part to this object. Up to mechanics.js nothing touches the page,
// so that node can test it.
const explorer = {};
