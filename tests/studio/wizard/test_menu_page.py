"""A page of the wizard that is a menu."""

from __future__ import annotations

from textual.app import App

from plastron_tui.studio.wizard.menu_page import Item, Menu, MenuPage, _words


async def test_a_page_that_is_left_before_it_is_there_is_no_failure() -> None:
    app: App[None] = App()
    async with app.run_test():
        page = MenuPage("what now?", [Item("one"), Item("two")])
        mounted = app.mount(page)
        removed = page.remove()
        await mounted
        await removed


async def test_the_cursor_is_where_it_was_and_the_menu_has_the_keys() -> None:
    app: App[None] = App()
    async with app.run_test() as pilot:
        await app.mount(
            MenuPage("what now?", [Item("one"), Item("two", closed="no"), Item("x")], 2)
        )
        await pilot.pause()
        menu = app.query_one(Menu)
        assert (menu.option_count, menu.highlighted, menu.has_focus) == (3, 2, True)


def test_what_cannot_be_chosen_is_no_louder_than_what_can() -> None:
    free, closed = _words(Item("go", about="far")), _words(Item("go", about="far", closed="no"))
    assert closed.plain == "Go\n  Not now: no"
    assert closed.spans[-1].style == free.spans[-1].style
    assert closed.spans[0].style != free.spans[0].style


async def test_pages_of_a_menu_lead_to_entries() -> None:
    app: App[None] = App()
    async with app.run_test(size=(60, 9)) as pilot:
        items = [Item(str(number), closed="no" if number > 5 else "") for number in range(9)]
        await app.mount(MenuPage("what now?", items))
        menu = app.query_one(Menu)
        await pilot.pause()
        seen = [menu.highlighted]
        for key in ("pagedown", "pagedown", "pagedown", "pageup", "pageup", "pageup"):
            await pilot.press(key)
            seen.append(menu.highlighted)
        assert None not in seen
        assert (seen[0], seen[3], seen[6]) == (0, 5, 0)
        assert seen[1] not in (0, 5)
        menu.highlighted = None
        await pilot.press("enter")
        assert menu.highlighted == 0
