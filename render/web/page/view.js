// The picture: blocks of passes, coarse to fine, drawn over each other.
const picture = document.getElementById("picture");
const paper = picture.getContext("2d");
const small = document.createElement("canvas");

function pixelsOf(text, channels, width, height) {
  const bytes = atob(text), image = new ImageData(width, height), to = image.data;
  for (let i = 0, k = 0; k < to.length; i += channels, k += 4) {
    to[k] = bytes.charCodeAt(i);
    to[k + 1] = bytes.charCodeAt(i + 1);
    to[k + 2] = bytes.charCodeAt(i + 2);
    to[k + 3] = channels === 4 ? bytes.charCodeAt(i + 3) : 255;
  }
  return image;
}

function drawBlock(block) {
  const image = pixelsOf(block.d, block.c, block.w, block.h);
  if (block.W === picture.width && block.H === picture.height) return paper.putImageData(image, block.x, block.y);
  small.width = block.w;
  small.height = block.h;
  small.getContext("2d").putImageData(image, 0, 0);
  const sx = picture.width / block.W, sy = picture.height / block.H;
  paper.imageSmoothingEnabled = false;
  paper.drawImage(small, block.x * sx, block.y * sy, block.w * sx, block.h * sy);
}
