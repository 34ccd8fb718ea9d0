// What the explorer's and the playground's pages draw with, one global name; the files of
// scripts.txt are joined in that order, before a page's own. It knows no scene.
'use strict';
const drawing = {};
