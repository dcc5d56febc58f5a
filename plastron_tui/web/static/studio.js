"use strict";

document.addEventListener("DOMContentLoaded", () => {
  for (const id of ["start", "again"]) {
    document.getElementById(id).addEventListener("click", () => window.location.replace("/"));
  }
});
