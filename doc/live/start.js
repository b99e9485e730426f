for (const root of document.querySelectorAll(".live")) live(root, pages[root.dataset.page]);
