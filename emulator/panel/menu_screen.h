#pragma once

#include "panel_screen.h"

#include <QList>

namespace lds::emulator {

/// One level of the setting mode (§2.2): UP and DOWN go through its entries, ENTER opens the level or the
/// setting below, a long ENTER goes back, from the first level to the measurement display.
class MenuScreen final : public PanelScreen {
public:
    /// `parent`: the number of the entry whose entries these are; 0 for the first level.
    explicit MenuScreen(PanelHost& host, int parent = 0);

    void gesture(Gesture gesture) override;
    void draw(DisplayContent& content) const override;

private:
    void move(int by);
    void openShown();

    QList<const catalog::MenuEntry*> m_entries;
    qsizetype m_shown = 0;
};

} // namespace lds::emulator
