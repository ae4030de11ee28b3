#pragma once

#include "panel_screen.h"

namespace lds::emulator {

/// Words that stay for a while and go away by themselves; the keys mean nothing meanwhile.
class MessageScreen final : public PanelScreen {
public:
    /// `then` runs after the screen has closed itself.
    MessageScreen(PanelHost& host, const char* english, std::function<void()> then = {})
        : PanelScreen(host)
        , m_english(english)
        , m_then(std::move(then))
    {}

    void shown() override
    {
        later(messageMs, [this] {
            host().close();
            if (m_then)
                m_then();
        });
    }
    void gesture(Gesture) override {}
    void draw(DisplayContent& content) const override
    {
        content.screen = ScreenKind::Message;
        content.body = host().text(m_english);
    }

private:
    const char* m_english;
    std::function<void()> m_then;
};

} // namespace lds::emulator
