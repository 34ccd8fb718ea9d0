// The playground's one global name; the files of scripts.txt are joined in that order behind those
// of src/draw/script. Up to solver.js nothing touches the page, so that node can test it.
const play = {};
