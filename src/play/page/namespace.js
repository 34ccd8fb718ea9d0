// The playground's one global name; the files of scripts.txt are joined in that order. Up to
// solver.js nothing touches the page, so that node can test it.
'use strict';
const play = {};
